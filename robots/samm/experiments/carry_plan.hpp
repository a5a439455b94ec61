#pragma once

#include "two_robots.hpp"

namespace treeline::experiments {

/// The task: after a second at rest the object moves in a horizontal circle, rising and rotating,
/// with a time law that is cubic. Meanwhile the squeeze grows and a torsion is applied.
struct CarryPlan {
  double rate = 1000.0;                       ///< Hz
  double lead = 1.0;                          ///< time at rest, s
  double duration = 8.0;                      ///< duration of the circle, s
  double settle = 1.0;                        ///< time afterwards, s
  double radius = 0.25;                       ///< m
  double rise = 0.1;                          ///< half of the height gained at the far side, m
  double yaw = 0.5;                           ///< in both directions, rad
  double stiffness = 2500;                    ///< for the object's pose, 1/s^2
  double damping = 100;                       ///< 1/s
  double posture = 25;                        ///< the same for all joints, critically damped, 1/s^2
  double squeeze_from = 20, squeeze_to = 60;  ///< grows from 3 s to 4 s, N
  double torsion = 2;                         ///< applied from 5 s to 6 s, N m
  int substeps = 2;
};

/// Desired motion of the object at a time, six rows each.
struct Wanted {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
  double acceleration[6] = {};
  double yaw = 0.0;
  double yaw_rate = 0.0;
  double internal[6] = {};
};

Wanted wanted_at(const CarryPlan& plan, double time);

/// Both robots hold the object at the start of the plan, elbows up, opposite each other.
PairState start_state();

/// The desired acceleration of the posture: the bases move with the object as if all were one body,
/// the arms stay as they were at the start.
void advise(const CarryPlan& plan, const PairState& start, const PairState& state,
            const Wanted& wanted, double (&qdd_0)[2][kJoints]);

}  // namespace treeline::experiments
