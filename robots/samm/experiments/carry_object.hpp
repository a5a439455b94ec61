#pragma once

#include <string>

#include "servo/plot.hpp"
#include "servo/statistics.hpp"
#include "servo/table.hpp"
#include "two_robots.hpp"

namespace treeline::experiments {

/// The task: after a second at rest the object goes round a horizontal circle, rising and turning,
/// in a time law that is cubic; meanwhile the squeeze grows and a torsion is put on.
struct CarryPlan {
  double rate = 1000.0;                       ///< Hz
  double lead = 1.0;                          ///< s at rest
  double duration = 8.0;                      ///< s of the round
  double settle = 1.0;                        ///< s afterwards
  double radius = 0.25;                       ///< m
  double rise = 0.1;                          ///< m, half of the height gained at the far side
  double yaw = 0.5;                           ///< rad, either way
  double stiffness = 2500;                    ///< 1/s^2, of the object's pose
  double damping = 100;                       ///< 1/s
  double posture = 25;                        ///< 1/s^2, the same for all joints; critically damped
  double squeeze_from = 20, squeeze_to = 60;  ///< N, grows from 3 s to 4 s
  double torsion = 2;                         ///< N m, comes from 5 s to 6 s
  int substeps = 2;
};

/// What the object shall do at a time, six rows a line.
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

struct CarryOutcome {
  explicit CarryOutcome(std::size_t rows);
  servo::Table table;  ///< a row per cycle
  servo::DurationStatistics control;
};

/// Largest errors over the run. Internal forces at the end of a cycle under one torque.
struct CarryErrors {
  double position = 0.0;  ///< m
  double rotation = 0.0;  ///< rad
  double tension = 0.0;   ///< N
  double moments = 0.0;   ///< N m
  double drift = 0.0;     ///< m
  double drift_rotation = 0.0;
  double travel = 0.0;  ///< m that the first base moved at most
};

CarryOutcome carry_object(const CarryPlan& plan);
CarryErrors largest_errors(const CarryOutcome& outcome);
/// What the run must keep.
bool within_bounds(const CarryErrors& errors);
std::string summary(const CarryOutcome& outcome);
servo::Plot figure(const CarryOutcome& outcome);

}  // namespace treeline::experiments
