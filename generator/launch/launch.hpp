#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "compilation/temporary_folder.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "drive/robot_description.hpp"
#include "launch/driven_library.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Content of the files that a robot is made of.
struct LaunchInput {
  Robot robot;
  Scene scene;
  std::string urdf_text, scene_text;
  SceneSurroundings surroundings;
};

/// By which front ends and records know a robot: 16 hexadecimal digits of its files.
std::string checksum_of(const std::string& urdf_text, const std::string& scene_text);

/// A robot that is ready to be driven.
struct LaunchedRobot {
  drive::RobotDescription description;
  std::unique_ptr<TemporaryFolder> folder;  ///< of the library; outlives it
  DrivenLibrary library;
  Robot robot;
  Scene scene;  ///< that it is driven by
};

/// Generates a robot's code, compiles it together with the control loop, and loads it. `accepts` is
/// asked about the robot before anything is compiled; where it refuses, with an error of its own,
/// there is no robot. `tell` receives what is being done, `compiled 3/9`. Errors: see
/// `control_scene`, the compiler's.
std::optional<LaunchedRobot> launch(
    const LaunchInput& input, const std::function<bool(const drive::RobotDescription&)>& accepts,
    const std::function<void(const std::string&)>& tell, Diagnostics& diagnostics);

}  // namespace treeline
