#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

namespace treeline::growth {

/// A robot of the folder `robots` in one of its scenes.
struct RobotInScene {
  Robot robot;
  Scene scene;
};

/// Reads every file `scene*.yaml` beside a URDF, in order of name. Files that cannot be read are
/// left out and reported in `diagnostics`.
inline std::vector<RobotInScene> scenes_of_robots(const std::filesystem::path& robots,
                                                  Diagnostics& diagnostics) {
  std::vector<std::filesystem::path> urdfs, scenes;
  for (const auto& file : std::filesystem::recursive_directory_iterator(robots)) {
    const bool is_scene = file.path().filename().string().starts_with("scene");
    if (file.path().extension() == ".urdf") urdfs.push_back(file.path());
    if (is_scene && file.path().extension() == ".yaml") scenes.push_back(file.path());
  }
  std::sort(scenes.begin(), scenes.end());
  std::vector<RobotInScene> all;
  for (const std::filesystem::path& path : scenes) {
    for (const std::filesystem::path& urdf : urdfs) {
      if (urdf.parent_path() != path.parent_path()) continue;
      const auto robot = read_urdf(urdf.string(), diagnostics);
      if (!robot) continue;
      const auto scene = read_scene(path.string(), *robot, diagnostics);
      if (scene) all.push_back({*robot, *scene});
    }
  }
  return all;
}

}  // namespace treeline::growth
