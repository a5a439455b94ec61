#pragma once

#include <string>

#include "plan.hpp"
#include "servo/plot.hpp"
#include "servo/table.hpp"

/// Balance as posture (Chang section 2.5): the left hand reaches farther than the body can follow
/// without falling, unless the centre of mass is kept over the feet in the hand's null space.
namespace treeline::experiments {

struct BalanceFigures {
  double margin = 1e9;  ///< m, of the centre of mass within the feet's edges; negative outside
  double position_error = 0.0;  ///< m, of the hand
  double rotation_error = 0.0;  ///< rad
  double torque = 0.0;          ///< share of a joint's effort limit
  double limit_margin = 1e9;    ///< rad, of the joint nearest to a limit
};

struct BalanceRun {
  servo::Table table;  ///< a row every millisecond
  BalanceFigures figures;
};

/// 6 s at 1 kHz on generated code, from the plan's start with its posture; with the law or without.
BalanceRun run_balance(const Plan& plan, const JointLimits& limits, bool balancing);

std::string balance_summary(const BalanceRun& balancing, const BalanceRun& without);
servo::Plot balance_figure(const BalanceRun& balancing, const BalanceRun& without,
                           const Plan& plan);

/// Without the law the centre of mass leaves the feet by a centimetre or more, with it it stays
/// 2 cm within; the hand tracks to 1e-5 m and 1e-4 rad either way, joints and torques stay within
/// their limits with it.
bool balance_claim_holds(const BalanceRun& balancing, const BalanceRun& without);

}  // namespace treeline::experiments
