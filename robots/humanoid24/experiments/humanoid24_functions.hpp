#pragma once

#include "humanoid24.hpp"

namespace treeline::experiments {

/// The generated functions in the form that the servo library expects.
struct Humanoid24 {
  static constexpr int kCoordinates = humanoid24::kCoordinates;
  static constexpr int kVelocities = humanoid24::kVelocities;
  static constexpr int kTaskRows = humanoid24::kTaskRows;
  static constexpr auto& inverse_dynamics = humanoid24::inverse_dynamics;
  static constexpr auto& forward_dynamics = humanoid24::forward_dynamics;
  static constexpr auto& forward_kinematics = humanoid24::forward_kinematics;
  static constexpr auto& jacobian = humanoid24::jacobian;
  static constexpr auto& mass_matrix = humanoid24::mass_matrix;
  static constexpr auto& control_torque = humanoid24::control_torque;
};

}  // namespace treeline::experiments
