#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/read_robots.hpp"
#include "description/read_scene.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// What the files of a command line hold: a URDF, with or without a scene, or a scene that lists
/// its robots.
struct RobotFiles {
  std::string urdf;          ///< path of the one URDF; empty: the scene lists robots
  std::string urdf_text;     ///< content of the URDF
  std::string scene;         ///< path of the scene; empty: there is none
  std::string scene_text;    ///< content of the scene
  SceneRobots scene_robots;  ///< robots that the scene lists
};

struct RobotWithFiles {
  Robot robot;
  RobotFiles files;
};

/// For the options of a command that takes such files.
inline constexpr const char* kRobotArgument =
    "Robot, URDF, SDF or MJCF; or a scene that lists robots, YAML";

/// Reads robots and the text of the scene. `first` is a URDF and `second` its scene or empty, or
/// `first` is a scene with the key `robots`. Faults are in `diagnostics`.
std::optional<RobotWithFiles> read_robot_files(const std::string& first, const std::string& second,
                                               Diagnostics& diagnostics);

/// The scene of these files for the robot, or the default one; `functions` go before what it lists,
/// if there are any.
std::optional<Scene> parse_scene_of(const RobotWithFiles& read, Diagnostics& diagnostics,
                                    const std::vector<Function>& functions = {},
                                    FunctionsFrom from = FunctionsFrom::scene);

/// What lists functions by name: these, which an option gives, or the scene; empty: nothing does.
std::string place_of_list(const RobotFiles& files, const std::vector<Function>& functions);

/// The paths of all these files; standard input is none.
std::vector<std::string> list_paths(const RobotFiles& files);

/// The URDF's text; of several robots all in one, see `print_joined_urdf`.
std::string shown_urdf(const RobotFiles& files);

}  // namespace treeline
