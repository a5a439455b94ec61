#pragma once

#include <array>
#include <string>
#include <vector>

#include "circle_controller.hpp"
#include "servo/geared_robot.hpp"
#include "servo/plot.hpp"
#include "servo/safety.hpp"
#include "servo/statistics.hpp"
#include "servo/table.hpp"

namespace treeline::experiments {

/// What stands between the torques and the links of the simulated robot.
enum class DriveModel {
  ideal,     ///< nothing: torques act on the links
  friction,  ///< rotors against Coulomb and viscous friction, tight gears
  backlash,  ///< rotors without friction, gears with play
  worn,      ///< both
};
inline constexpr std::array kDriveModels{DriveModel::ideal, DriveModel::friction,
                                         DriveModel::backlash, DriveModel::worn};
const char* name_of(DriveModel model);
/// In words, for titles.
const char* describe(DriveModel model);

/// The motors, frictions and gears of the robot's README.md.
servo::Drives<9> samm_drives(DriveModel model);

/// Limits of the URDF.
servo::SafetyLimits<9, 9> samm_limits();

/// Largest errors, and the root of the mean square, over a run: where tool and base truly are, and
/// as the motors' encoders see them (`seen`).
struct CircleErrors {
  double tool = 0.0;  ///< m, distance
  double tool_rms = 0.0;
  double tool_seen = 0.0;
  double rotation = 0.0;  ///< rad
  double base = 0.0;
  double base_seen = 0.0;
  double base_travel = 0.0;  ///< m that the base was from its start at most
};

struct CircleRun {
  CirclePlan plan;
  DriveModel model = DriveModel::ideal;
  servo::Table table;  ///< a row per cycle
  servo::Fault fault;
  servo::DurationStatistics control;
  CircleErrors errors;
};

/// 1 kHz servo loop on the simulated robot. `moving`: the base draws its own circle.
CircleRun run_circles(DriveModel model, bool moving);

/// The runs of all models, each with the base at rest and then moving.
std::vector<CircleRun> run_all_circles();

/// File name without ending: tool_ideal, tool_and_base_worn and so on.
std::string file_name(const CircleRun& run);
std::string circles_summary(const std::vector<CircleRun>& runs);

/// Both circles over the plane and over time, errors (Chang fig. 6.6 and 6.7, or 6.8 to 6.11).
servo::Plot circles_figure(const CircleRun& run);

/// Chang section 6.4: the tool's error does not grow when the base moves, in any model; both follow
/// to micrometres with ideal drives; with friction and backlash errors are of the thesis's order,
/// four hundredths of the radius. Broken claims in words, a line each, or nothing.
std::string broken_circle_claims(const std::vector<CircleRun>& runs);

}  // namespace treeline::experiments
