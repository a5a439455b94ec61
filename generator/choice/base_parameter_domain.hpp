#pragma once

#include "bounds/domain.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Returns the range of base parameters: links have up to twice the mass and the extent that the
/// URDF gives, rotors and friction up to twice what the scene says, or `kUnstatedDrive` where it
/// says nothing.
BaseDomain base_parameter_domain(const Mechanism& mechanism);
inline constexpr double kUnstatedDrive = 0.1;  ///< kg m^2, kg; N m s/rad, N s/m; N m, N

/// Adds the ranges of base parameters if they are an argument.
void add_base_parameters(const Mechanism& mechanism, Domain& domain);

}  // namespace treeline
