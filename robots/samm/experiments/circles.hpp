#pragma once

#include <array>
#include <string>
#include <vector>

#include "circle_controller.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/geared_robot.hpp"
#include "servo/safety.hpp"
#include "servo/statistics.hpp"

namespace treeline::experiments {

/// Drives between the torques and the links of the simulated robot.
enum class DriveModel {
  ideal,     ///< torques act on the links directly
  friction,  ///< rotors with Coulomb and viscous friction, gears without play
  backlash,  ///< rotors without friction, gears with play
  worn,      ///< friction and backlash
};
inline constexpr std::array kDriveModels{DriveModel::ideal, DriveModel::friction,
                                         DriveModel::backlash, DriveModel::worn};
const char* name_of(DriveModel model);
/// Description of the model in words, for titles.
const char* describe(DriveModel model);

/// Motors, friction and gears as in the robot's README.md.
servo::Drives<9> samm_drives(DriveModel model);

/// Safety limits from the URDF.
servo::SafetyLimits<9, 9> samm_limits();

/// Largest and root-mean-square errors over a run: for the true places of tool and base, and as
/// seen by the motors' encoders (`seen`).
struct CircleErrors {
  double tool = 0.0;  ///< distance, m
  double tool_rms = 0.0;
  double tool_seen = 0.0;
  double rotation = 0.0;  ///< rad
  double base = 0.0;
  double base_seen = 0.0;
  double base_travel = 0.0;  ///< largest distance of the base from its start, m
};

struct CircleRun {
  CirclePlan plan;
  DriveModel model = DriveModel::ideal;
  report::Table table;  ///< one row per cycle
  servo::Fault fault;
  servo::DurationStatistics control;
  CircleErrors errors;
};

/// Runs a 1 kHz servo loop on the simulated robot. With `moving` the base moves in its own circle.
CircleRun run_circles(DriveModel model, bool moving);

/// Runs all models, each with the base at rest and then moving.
std::vector<CircleRun> run_all_circles();

/// File name without extension: tool_ideal, tool_and_base_worn and so on.
std::string file_name(const CircleRun& run);
std::string circles_summary(const std::vector<CircleRun>& runs);

/// Draws both circles in their planes and over time, and the errors (Chang fig. 6.6 and 6.7, or 6.8
/// to 6.11).
report::Plot circles_figure(const CircleRun& run);

/// Checks Chang section 6.4: in every model the tool's error does not grow when the base moves;
/// with ideal drives both follow to micrometres; with friction and backlash the errors have the
/// order of the thesis's, four hundredths of the radius. Returns the broken claims in words, one
/// per line; empty if there are none.
std::string broken_circle_claims(const std::vector<CircleRun>& runs);

}  // namespace treeline::experiments
