#pragma once

#include <string>

#include "object_outcome.hpp"

namespace treeline::experiments {

/// Two humanoids lift a ladder, carry it aside and turn it, squeezing its rails.
struct LadderPlan {
  double rate = 1000.0;                  ///< Hz
  double lead = 0.5;                     ///< at rest before and after, s
  double duration = 3.0;                 ///< of the motion, s
  double shift[3] = {0.03, 0.04, 0.08};  ///< m
  double turn = 0.04;                    ///< about the vertical, rad
  double stiffness = 400;                ///< for the ladder's pose, 1/s^2
  double damping = 40;                   ///< 1/s
  double squeeze = 20;                   ///< between the hands of each, N
  int substeps = 2;
};

struct LadderOutcome : ObjectOutcome {};

/// Largest errors over the run. Internal forces are those at the end of a cycle with constant
/// torque.
struct LadderErrors {
  ObjectErrors object;
  double internal = 0;  ///< tensions, N, and moments, N m
};

LadderOutcome carry_ladder(const LadderPlan& plan);
LadderErrors largest_errors(const LadderOutcome& outcome);
/// Whether the run ends without a fault and keeps its bounds.
bool within_bounds(const LadderOutcome& outcome);
std::string summary(const LadderOutcome& outcome);
/// The table of the page.
std::string page_table(const LadderOutcome& outcome);
report::Plot figure(const LadderOutcome& outcome);

}  // namespace treeline::experiments
