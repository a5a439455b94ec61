#pragma once

#include <cmath>

namespace treeline::servo {

/// Friction of one drive, seen from the joint's side of its gear.
struct JointFriction {
  double coulomb = 0.0;     ///< N m, or N for a prismatic joint
  double viscous = 0.0;     ///< N m s/rad, or N s/m
  double slip_speed = 0.0;  ///< speed within which the Coulomb part builds up, rad/s or m/s;
                            ///< positive
};

/// Friction torque (N m or N) against a motion with `speed` (rad/s or m/s): a viscous part and a
/// Coulomb part, whose sign is smoothed to tanh(speed / slip speed) so that it can be integrated.
/// Under a torque below the Coulomb torque a joint creeps instead of sticking, at no more than the
/// slip speed unless the torque exceeds tanh(1) = 76 % of the Coulomb torque.
inline double friction_torque(const JointFriction& friction, double speed) noexcept {
  const double coulomb =
      friction.coulomb > 0.0 ? friction.coulomb * std::tanh(speed / friction.slip_speed) : 0.0;
  return coulomb + friction.viscous * speed;
}

}  // namespace treeline::servo
