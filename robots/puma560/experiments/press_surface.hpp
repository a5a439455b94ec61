#pragma once

#include <string>
#include <vector>

#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"

/// Force control in a selected direction whose frame moves (Khatib 1987): the PUMA's flange presses
/// on a springy plate that rocks and heaves, and slides on it in a circle.
namespace treeline::experiments {

/// Choice of the selection frame.
enum class Frame {
  moving,  ///< moves with the plate
  fixed,   ///< stays as the plate was at the start
};

/// Largest values from the time at which the plate moves.
struct PressFigures {
  double force_error = 0.0;  ///< desired minus measured, along the plate's normal, N
  double slide_error = 0.0;  ///< distance from the circle within the plate, m
  double tilt_error = 0.0;   ///< of the flange relative to the plate, rad
  double tilt = 0.0;         ///< rocking of the plate, rad
  double heave = 0.0;        ///< rise and fall of the flange, m
  double torque = 0.0;       ///< share of a joint's effort limit
  bool lost_contact = false;
};

struct PressRun {
  report::Table table;  ///< one row per millisecond
  PressFigures figures;
  servo::Fault fault;  ///< of the servo loop, which ends the run
};

/// Simulates 8 s at 1 kHz on the generated PUMA, controlled by the servo loop. The force comes from
/// the robot's sensor.
PressRun run_press(Frame frame);

std::string press_summary(const PressRun& moving, const PressRun& fixed);
report::Plot press_figure(const PressRun& moving, const PressRun& fixed);

/// Whether the claim holds. With the moving frame the force on the plate is within 1 N of the
/// desired 20 N while the plate rocks by more than 15 degrees, and the flange stays on its circle
/// to 0.1 mm and flat to 1 mrad. With the fixed frame force and circle disturb each other at least
/// ten times as much.
bool press_claim_holds(const PressRun& moving, const PressRun& fixed);

}  // namespace treeline::experiments
