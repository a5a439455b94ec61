#pragma once

#include <string>
#include <vector>

#include "lock_paths.hpp"
#include "servo/plot.hpp"
#include "servo/table.hpp"
#include "singular_control.hpp"

namespace treeline::experiments {

/// Largest values over a run, and where it ended.
struct LockFigures {
  double torque = 0.0;          ///< of a joint, as a share of its effort limit
  double speed = 0.0;           ///< rad/s, of a joint
  double position_error = 0.0;  ///< m
  double rotation_error = 0.0;  ///< rad
  double final_position_error = 0.0;
  double final_rotation_error = 0.0;
  double least_value = 1.0;  ///< smallest singular value on the way
  double final_q[6] = {};
  bool within_limits = true;  ///< every joint, of the URDF's angles
  /// Entering, in, leaving: the weakest direction is wholly in the task at the start, has wholly
  /// left it on the way, and is back at the end.
  bool three_phases = false;
  /// What the lost direction was found to be whenever it had left; `none` if that changed.
  core::SingularityType type = core::SingularityType::none;
  bool lost = false;  ///< torque above a thousand times the limit, or not finite: the run ended
};

struct LockRun {
  servo::Table table;  ///< time, errors, sigma, q, qd, tau, share, type; a row every millisecond
  LockFigures figures;
  double start[6] = {};        ///< q, rad
  bool began_regular = false;  ///< phases as far as they have been gone through
  bool was_in = false;
};

/// The path at 1 kHz on the simulated PUMA. `branch`: the side on which elbow or shoulder are to
/// come back, +1 through the lock, -1 the side they came from.
LockRun run_lock(Lock lock, Strategy strategy, double branch = 1.0);

/// A line for each run, in the order of kStrategies.
std::string lock_summary(Lock lock, const std::vector<LockRun>& runs);

/// Errors, phases, joints and torques of the runs (Chang fig. A.2, A.3).
servo::Plot lock_figure(Lock lock, const std::vector<LockRun>& runs);

/// The physical claim: with the strategy the lock is entered, stayed in and left, typed as Chang
/// does (elbow and head 1, wrist 2), joints and torques stay within their limits and speeds below 3
/// rad/s, the tool ends where it is wanted, elbow and shoulder on their other side; without it
/// torque exceeds the limits a thousandfold within milliseconds; damped least squares is bounded
/// too but leaves the path farther, and moves faster or comes back to the side it came from.
bool lock_claim_holds(Lock lock, const std::vector<LockRun>& runs);

}  // namespace treeline::experiments
