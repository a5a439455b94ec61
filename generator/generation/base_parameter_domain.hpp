#pragma once

#include "bounds/domain.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Of which bodies, rotors and friction base parameters may be: of links up to twice the mass and
/// the extent that they have in the URDF, of rotors and friction up to twice what the scene says,
/// or `kUnstatedDrive` where it says nothing.
BaseDomain base_parameter_domain(const Mechanism& mechanism);
inline constexpr double kUnstatedDrive = 0.1;  ///< kg m^2, kg; N m s/rad, N s/m; N m, N

/// Adds the ranges of base parameters if they are an argument.
void add_base_parameters(const Mechanism& mechanism, Domain& domain);

}  // namespace treeline
