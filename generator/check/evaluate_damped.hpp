#pragma once

#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// What `damped_control_torque` is composed from at one state, matrices row by row.
struct DampedInputs {
  std::vector<double> Lambda_inverse, J, bias;
  std::vector<double> tau;  ///< inverse dynamics at qdd_0
  std::vector<double> qdd_0, xdd_cmd, heaviest;
};

/// Torques, then the least ease, operation by operation as the emitted header has them in `real`,
/// by the headers of runtime/core that it is made from. Empty for more than 36 rows.
std::vector<double> evaluate_damped(Real real, const DampedInputs& inputs);

}  // namespace treeline
