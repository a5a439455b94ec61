#pragma once

#include <string>

#include "plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

/// Balance as posture (Chang section 2.5): the left hand reaches farther than the body can follow
/// without falling, unless the null space of the hand's task is used to keep the centre of mass
/// over the feet.
namespace treeline::experiments {

struct BalanceFigures {
  double margin = 1e9;  ///< of the centre of mass from the feet's edges, m; negative outside
  double position_error = 0.0;  ///< of the hand, m
  double rotation_error = 0.0;  ///< rad
  double torque = 0.0;          ///< largest share of a joint's effort limit
  double limit_margin = 1e9;    ///< distance of a joint from its nearest limit, rad
};

struct BalanceRun {
  report::Table table;  ///< one row per millisecond
  BalanceFigures figures;
};

/// Simulates 6 s at 1 kHz on generated code, from the plan's start with its posture, with or
/// without the balance law.
BalanceRun run_balance(const Plan& plan, const JointLimits& limits, bool balancing);

std::string balance_summary(const BalanceRun& balancing, const BalanceRun& without);
report::Plot balance_figure(const BalanceRun& balancing, const BalanceRun& without,
                            const Plan& plan);

/// Whether the claim holds: without the law the centre of mass leaves the feet by 1 cm or more;
/// with the law it stays 2 cm within. In both runs the hand tracks to 1e-5 m and 1e-4 rad. With the
/// law joints and torques stay within their limits.
bool balance_claim_holds(const BalanceRun& balancing, const BalanceRun& without);

}  // namespace treeline::experiments
