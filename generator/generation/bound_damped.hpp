#pragma once

#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// What the rounding errors of `damped_control_torque` are at states drawn from the domain, for the
/// contract: those of 50, 90 and 99 of 100. Measured against extended precision; no proof reaches
/// through the sweeps of an eigen-solver. `functions` are those that it calls, among others.
std::string describe_damped_rounding(const std::vector<GeneratedFunction>& functions,
                                     const Scene& scene, const Domain& domain);

}  // namespace treeline
