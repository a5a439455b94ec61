#pragma once

#include <string>

#include "outcome.hpp"
#include "plan.hpp"

namespace treeline::experiments {

/// Joints of the robot.
inline constexpr int kRockingJoints = 24;

/// Both hands hold their poses while the advised posture rocks the waist from side to side about
/// two of its axes. A front end sends the advice.
struct RockPlan {
  double rate = 1000.0;       ///< of the control, Hz
  double advice_rate = 30.0;  ///< of the front end's messages, Hz
  double lead = 0.5;          ///< at rest before, s
  double period = 4.0;        ///< of one rocking, s
  int rounds = 3;             ///< of which the first grows from rest and the last dies down
  double roll = 0.3;          ///< of the waist, to either side, rad
  double yaw = 0.4;           ///< of the waist, to either side, rad
  double stiffness = 100.0;   ///< of the posture, the same for all joints, 1/s^2

  double total() const noexcept { return lead + rounds * period + 1.0; }
};

/// Advised angles of the waist at a time, rad.
struct WaistAdvice {
  double roll = 0.0;
  double yaw = 0.0;
};
WaistAdvice advice_at(const RockPlan& plan, double time) noexcept;

/// Runs the rocking from the start of `pose`, whose task gains hold the hands.
Outcome rock_torso(const RockPlan& plan, const Plan& pose, const JointLimits& limits);

/// What has been found out.
struct RockFindings {
  double hands = 0.0;      ///< largest distance of a hand from its place, m
  double hands_rad = 0.0;  ///< largest rotation
  double roll = 0.0;       ///< from one side to the other, rad
  double yaw = 0.0;
};
RockFindings find_rocking(const Outcome& outcome, const Plan& pose);

/// Whether the run ends without a fault, the hands stay within 5 um, and the waist follows at least
/// three fifths of the advice.
bool rocks_without_hands(const Outcome& outcome, const RockPlan& plan, const Plan& pose);
std::string rock_summary(const Outcome& outcome, const RockPlan& plan, const Plan& pose);
report::Plot rock_figure(const Outcome& outcome, const Plan& pose);

}  // namespace treeline::experiments
