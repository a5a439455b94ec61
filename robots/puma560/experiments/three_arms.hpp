#pragma once

#include <string>

#include "object_outcome.hpp"

namespace treeline::experiments {

/// Three arms lift a beam, carry it aside and turn it, and put it back, while they pull it apart as
/// commanded.
struct ThreeArmsPlan {
  double rate = 1000.0;                ///< Hz
  double lead = 0.5;                   ///< at rest before each motion and at the end, s
  double duration = 2.0;               ///< of each of the two motions, s
  double shift[3] = {0.1, 0.06, 0.1};  ///< m
  double turn = 0.35;                  ///< about the vertical, rad
  double stiffness = 400;              ///< for the beam's pose, 1/s^2
  double damping = 40;                 ///< 1/s
  double tensions[3] = {15, 10, 5};    ///< of the rods 12, 23, 31 of the virtual linkage, N
  int substeps = 2;
};

struct ThreeArmsOutcome : ObjectOutcome {};

/// Largest errors over the run. Internal forces are those at the end of a cycle with constant
/// torque.
struct ThreeArmsErrors {
  ObjectErrors object;
  double tensions = 0;  ///< N
  double moments = 0;   ///< N m
};

ThreeArmsOutcome carry_with_three_arms(const ThreeArmsPlan& plan);
ThreeArmsErrors largest_errors(const ThreeArmsOutcome& outcome);
/// Whether the run ends without a fault and keeps its bounds.
bool within_bounds(const ThreeArmsOutcome& outcome);
std::string summary(const ThreeArmsOutcome& outcome);
/// The table of the page.
std::string page_table(const ThreeArmsOutcome& outcome);
report::Plot figure(const ThreeArmsOutcome& outcome);

}  // namespace treeline::experiments
