#pragma once

#include <string>
#include <vector>

#include "report/plot.hpp"
#include "report/table.hpp"

/// Joint-limit avoidance as posture (Chang section 2.5): SAMM's tool rotates in place about the
/// vertical, farther than the arm alone can; the base has to go round.
namespace treeline::experiments {

struct AvoidFigures {
  double margin = 1e9;          ///< least distance of a joint from its limit, rad; negative beyond
  int joint = 0;                ///< index of that joint, counted from 0
  double position_error = 0.0;  ///< of the tool, m
  double rotation_error = 0.0;  ///< rad
  double base_travel = 0.0;     ///< m
  double torque = 0.0;          ///< share of a joint's effort limit
  bool fault = false;           ///< the servo loop ended the run
};

struct AvoidRun {
  report::Table table;  ///< one row per millisecond
  AvoidFigures figures;
};

/// Simulates 7 s at 1 kHz on generated/samm. The desired posture is the initial one; limits are
/// avoided or not.
AvoidRun run_avoid_limits(bool avoiding);

std::string avoid_summary(const AvoidRun& avoiding, const AvoidRun& without);
report::Plot avoid_figure(const AvoidRun& avoiding, const AvoidRun& without);

/// Whether the claim holds: without avoidance a joint exceeds its limit; with it all joints keep a
/// distance of at least 0.02 rad. In both runs the tool tracks to 1e-5 m and 1e-4 rad.
bool avoid_claim_holds(const AvoidRun& avoiding, const AvoidRun& without);

}  // namespace treeline::experiments
