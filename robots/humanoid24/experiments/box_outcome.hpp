#pragma once

#include <array>
#include <string>
#include <vector>

#include "plan.hpp"
#include "servo/plot.hpp"
#include "servo/safety.hpp"
#include "servo/statistics.hpp"
#include "servo/table.hpp"

namespace treeline::experiments {

/// What put_box.yaml says: `run.target` is the box's, `run.posture_stiffness` springs in N m/rad,
/// `internal` the commanded internal forces.
struct BoxPlan {
  Plan run;
  double posture_damping = 0.0;  ///< ratio to the critical one
  std::array<double, 6> internal{};
};

/// As `read_plan`.
bool read_box_plan(const std::string& path, BoxPlan& plan, std::string& error);

/// Columns before the joints': time; three wanted and three actual coordinates of the box, distance
/// and angle between them; the same of the drift of the grasps; six internal forces; control time
/// in us.
inline constexpr int kBoxColumns = 18;

std::vector<std::string> box_table_names(const std::vector<std::string>& joints);

struct BoxOutcome {
  BoxOutcome(std::vector<std::string> names, std::size_t rows) : table(std::move(names), rows) {}

  servo::Table table;  ///< a row per running cycle
  servo::Fault fault;
  servo::DurationStatistics control;  ///< compute time of the controller
  double initial_gap = 0.0;           ///< of the grasps once the start was closed, m or rad
};

/// Largest errors over the run.
struct BoxErrors {
  double position = 0.0;         ///< m, wanted to actual
  double rotation = 0.0;         ///< rad
  double internal_force = 0.0;   ///< N, of the tension
  double internal_moment = 0.0;  ///< N m, of the others
  double drift = 0.0;            ///< m, of the grasps
  double drift_rotation = 0.0;   ///< rad
};

BoxErrors largest_box_errors(const BoxOutcome& outcome, const BoxPlan& plan);

/// What the run must keep.
inline constexpr double kBoxPositionBound = 1e-4;  ///< m
inline constexpr double kBoxForceBound = 1e-2;     ///< N and N m, of internal forces
inline constexpr double kBoxDriftBound = 1e-10;    ///< m and rad
bool box_within_bounds(const BoxErrors& errors);

/// The thesis's time for one step: 1.5 ms on a 266 MHz Pentium II (section 7.5).
inline constexpr double kBoxThesisMicroseconds = 1500.0;

/// The figures in words, a line each.
std::string box_summary(const BoxOutcome& outcome, const BoxPlan& plan);

/// Chang fig. 7.10 and what belongs to it: the box, errors, internal forces, posture, torques.
servo::Plot box_figure(const BoxOutcome& outcome, const BoxPlan& plan);

}  // namespace treeline::experiments
