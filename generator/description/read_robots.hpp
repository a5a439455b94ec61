#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/join_robots.hpp"
#include "description/robot.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A file that was read.
struct InputFile {
  std::string name;  ///< as whoever asked for it wrote it
  std::string path;  ///< where it was found
  std::string text;
};

/// The robots that a scene lists under `robots`.
struct SceneRobots {
  std::vector<PlacedRobot> robots;         ///< in the scene's order
  std::vector<InputFile> files;            ///< their URDFs, each once, in the order of first use
  std::vector<std::size_t> file_of_robot;  ///< index into `files`, for each robot
};

/// Whether a file holds a scene and no URDF: it is a map in YAML. Nothing else is said of it.
bool is_scene_text(const std::string& text);

/// Whether a scene lists robots; false for a text that is no scene.
bool lists_robots(const std::string& scene_text);

/// Reads the robots that a scene lists: `name`, `urdf`, `pose: {xyz, rpy}` of a fixed base, and
/// `base`, which is `default_base` unless given. Paths are relative to the folder of the scene, for
/// standard input to the current one. A URDF that several robots share is read once. Faults are in
/// `diagnostics`, those of a URDF with its file and line; nothing is returned when one is an error.
std::optional<SceneRobots> read_robots(const std::string& scene_text, const std::string& scene_path,
                                       Diagnostics& diagnostics);

}  // namespace treeline
