#pragma once

#include <array>
#include <string>
#include <vector>

#include "plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"
#include "servo/statistics.hpp"

namespace treeline::experiments {

/// Content of put_box.yaml. `run.target` is that of the box, `run.posture_stiffness` are springs in
/// N m/rad, `internal` are the commanded internal forces.
struct BoxPlan {
  Plan run;
  double posture_damping = 0.0;  ///< ratio to critical damping
  std::array<double, 6> internal{};
};

/// Reads the plan at `path`. Returns false, with the reason in `error`, if something is missing or
/// of the wrong kind, as `read_plan` does.
bool read_box_plan(const std::string& path, BoxPlan& plan, std::string& error);

/// Number of columns before those of the joints: time; three desired and three actual coordinates
/// of the box, distance and angle between the two poses; distance and angle of the drift of the
/// grasps; six internal forces; control time in us.
inline constexpr int kBoxColumns = 18;

std::vector<std::string> box_table_names(const std::vector<std::string>& joints);

struct BoxOutcome {
  BoxOutcome(std::vector<std::string> names, std::size_t rows) : table(std::move(names), rows) {}

  report::Table table;  ///< one row per cycle in the running mode
  servo::Fault fault;
  servo::DurationStatistics control;  ///< compute time of the controller
  double initial_gap = 0.0;           ///< of the grasps after the start was closed, m or rad
};

/// Largest errors over the run.
struct BoxErrors {
  double position = 0.0;         ///< desired to actual, m
  double rotation = 0.0;         ///< rad
  double internal_force = 0.0;   ///< of the tension, N
  double internal_moment = 0.0;  ///< of the other internal forces, N m
  double drift = 0.0;            ///< of the grasps, m
  double drift_rotation = 0.0;   ///< rad
  double final_speed = 0.0;      ///< of the fastest joint in the last cycle, rad/s
};

BoxErrors largest_box_errors(const BoxOutcome& outcome, const BoxPlan& plan);

/// Bounds that the run must keep.
inline constexpr double kBoxRestBound = 0.02;      ///< of joints at the end, rad/s
inline constexpr double kBoxPositionBound = 1e-4;  ///< m
inline constexpr double kBoxForceBound = 1e-2;     ///< of internal forces, N and N m
inline constexpr double kBoxDriftBound = 1e-10;    ///< m and rad
bool box_within_bounds(const BoxErrors& errors);
/// Whether the body has come to rest at the end, too.
bool box_rests(const BoxErrors& errors);

/// Time for one step in the thesis: 1.5 ms on a 266 MHz Pentium II (section 7.5).
inline constexpr double kBoxThesisMicroseconds = 1500.0;

/// Prints the figures in words, one per line.
std::string box_summary(const BoxOutcome& outcome, const BoxPlan& plan);

/// Draws Chang fig. 7.10 and related curves: the box, errors, internal forces, posture, torques.
report::Plot box_figure(const BoxOutcome& outcome, const BoxPlan& plan);

}  // namespace treeline::experiments
