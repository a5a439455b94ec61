#pragma once

#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Describes the rounding errors of `damped_control_torque` for the contract: those of 50, 90 and
/// 99 of 100 states drawn from the domain. They are measured against extended precision, because no
/// bound can be proven for the sweeps of an eigenvalue solver. `functions` must include those that
/// it calls.
std::string describe_damped_rounding(const std::vector<GeneratedFunction>& functions,
                                     const Scene& scene, const Domain& domain);

}  // namespace treeline
