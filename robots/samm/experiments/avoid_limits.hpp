#pragma once

#include <string>
#include <vector>

#include "servo/plot.hpp"
#include "servo/table.hpp"

/// Joint-limit avoidance as posture (Chang section 2.5): SAMM's tool turns in place about the
/// vertical, farther than the arm alone can; the base has to go round.
namespace treeline::experiments {

struct AvoidFigures {
  double margin = 1e9;  ///< rad, least distance of any joint from its limit; negative beyond
  int joint = 0;        ///< which one, counted from 0
  double position_error = 0.0;  ///< m, of the tool
  double rotation_error = 0.0;  ///< rad
  double base_travel = 0.0;     ///< m
  double torque = 0.0;          ///< share of a joint's effort limit
};

struct AvoidRun {
  servo::Table table;  ///< a row every millisecond
  AvoidFigures figures;
};

/// 7 s at 1 kHz on generated/samm; the posture is advised to stay, limits avoided or not.
AvoidRun run_avoid_limits(bool avoiding);

std::string avoid_summary(const AvoidRun& avoiding, const AvoidRun& without);
servo::Plot avoid_figure(const AvoidRun& avoiding, const AvoidRun& without);

/// Without avoidance a joint goes beyond its limit, with it none comes nearer than 0.02 rad; the
/// tool tracks to 1e-5 m and 1e-4 rad either way.
bool avoid_claim_holds(const AvoidRun& avoiding, const AvoidRun& without);

}  // namespace treeline::experiments
