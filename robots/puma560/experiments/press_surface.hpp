#pragma once

#include <string>
#include <vector>

#include "servo/plot.hpp"
#include "servo/table.hpp"

/// Force control in a selected direction whose frame moves (Khatib 1987): the
/// PUMA's flange presses on a springy plate that rocks and heaves, and slides on it in a circle.
namespace treeline::experiments {

/// How the selection frame is taken.
enum class Frame {
  moving,  ///< with the plate
  fixed,   ///< as the plate was at the start
};

/// Largest values once the plate moves.
struct PressFigures {
  double force_error = 0.0;  ///< N, wanted less felt, along the plate's normal
  double slide_error = 0.0;  ///< m, from the circle, within the plate
  double tilt_error = 0.0;   ///< rad, of the flange against the plate
  double tilt = 0.0;         ///< rad, that the plate rocked
  double heave = 0.0;        ///< m, that the flange rose and sank
  double torque = 0.0;       ///< share of a joint's effort limit
  bool lost_contact = false;
};

struct PressRun {
  servo::Table table;  ///< a row every millisecond
  PressFigures figures;
};

/// 8 s at 1 kHz on the generated PUMA.
PressRun run_press(Frame frame);

std::string press_summary(const PressRun& moving, const PressRun& fixed);
servo::Plot press_figure(const PressRun& moving, const PressRun& fixed);

/// With the frame that moves the plate feels the wanted force to 1 N of 20 while it rocks by more
/// than 15 degrees, the flange stays on its circle to 0.1 mm and flat to 1 mrad; with a fixed one
/// force and circle disturb each other at least ten times as much.
bool press_claim_holds(const PressRun& moving, const PressRun& fixed);

}  // namespace treeline::experiments
