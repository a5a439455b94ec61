#pragma once

#include <string>
#include <vector>

#include "lock_paths.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "singular_control.hpp"

namespace treeline::experiments {

/// Largest values over a run, and the state at its end.
struct LockFigures {
  double torque = 0.0;          ///< of a joint, as a share of its effort limit
  double speed = 0.0;           ///< of a joint, rad/s
  double position_error = 0.0;  ///< m
  double rotation_error = 0.0;  ///< rad
  double final_position_error = 0.0;
  double final_rotation_error = 0.0;
  double least_value = 1.0;  ///< smallest singular value on the path
  double final_q[6] = {};
  bool within_limits = true;  ///< every joint stayed within its limits in the URDF
  /// Three phases occurred, entering, in, leaving: the weakest direction is wholly in the task at
  /// the start, leaves it completely on the path, and is back at the end.
  bool three_phases = false;
  /// Type of the lost direction, whenever it had left; `none` if it changed.
  core::SingularityType type = core::SingularityType::none;
  bool lost = false;  ///< a torque exceeded a thousand times its limit, or was not finite
};

struct LockRun {
  report::Table table;  ///< time, errors, sigma, q, qd, tau, share, type; one row per millisecond
  LockFigures figures;
  double start[6] = {};        ///< q, rad
  bool began_regular = false;  ///< the phases completed so far
  bool was_in = false;
};

/// Follows the path at 1 kHz on the simulated PUMA. `branch` is the side on which elbow or shoulder
/// shall come back: +1 through the lock, -1 the side from which they came.
LockRun run_lock(Lock lock, Strategy strategy, double branch = 1.0);

/// Heads the table of `lock_rows`.
inline constexpr const char* kLockTableHead =
    "| | torque / effort limit | speed rad/s | tool off by m | by rad |\n|---|---|---|---|---|\n";

/// Prints a line for each run, in the order of kStrategies.
std::string lock_summary(Lock lock, const std::vector<LockRun>& runs);

/// The runs' rows of the page's table, Markdown.
std::string lock_rows(Lock lock, const std::vector<LockRun>& runs);

/// Draws errors, phases, joints and torques of the runs (Chang fig. A.2, A.3).
report::Plot lock_figure(Lock lock, const std::vector<LockRun>& runs);

/// Whether the physical claim holds. With the strategy the lock is entered, stayed in and left, and
/// has Chang's type (elbow and head 1, wrist 2); joints and torques stay within their limits and
/// speeds below 3.6 rad/s; the tool ends at its desired pose, elbow and shoulder on their other
/// side. Without the strategy a torque exceeds its limit a thousandfold within milliseconds. Damped
/// least squares is bounded too, but it leaves the path farther, and moves faster or comes back to
/// the side from which it came.
bool lock_claim_holds(Lock lock, const std::vector<LockRun>& runs);

}  // namespace treeline::experiments
