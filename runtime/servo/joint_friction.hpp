#pragma once

#include <cmath>

namespace treeline::servo {

/// Friction of one drive, at the joint's side of its gear.
struct JointFriction {
  double coulomb = 0.0;     ///< N m, or N for a prismatic joint
  double viscous = 0.0;     ///< N m s/rad, or N s/m
  double slip_speed = 0.0;  ///< rad/s or m/s within which the Coulomb part builds up; positive
};

/// The torque against a motion of `speed`: Coulomb's with the sign smoothed to tanh(speed / slip
/// speed), so that it can be integrated, and the viscous one. What is at rest creeps under less
/// than the Coulomb torque instead of sticking: by no more than the slip speed, unless the torque
/// exceeds tanh(1) = 76 % of it.
inline double friction_torque(const JointFriction& friction, double speed) noexcept {
  const double coulomb =
      friction.coulomb > 0.0 ? friction.coulomb * std::tanh(speed / friction.slip_speed) : 0.0;
  return coulomb + friction.viscous * speed;
}

}  // namespace treeline::servo
