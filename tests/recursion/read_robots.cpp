#include "recursion/read_robots.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

namespace treeline::tests {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics.list()) text += to_string(d) + "\n";
  throw std::runtime_error(text);
}

std::vector<Path> sorted_entries(const Path& folder) {
  std::vector<Path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Whether a file is a scene. Other YAML files in the folder contain tasks.
bool is_scene(const Path& path) {
  return path.extension() == ".yaml" && path.stem().string().rfind("scene", 0) == 0;
}

/// Whether the folder belongs to a robot. Another one has the programs that draw pictures.
bool is_of_a_robot(const Path& folder) {
  if (!std::filesystem::is_directory(folder)) return false;
  const std::vector<Path> files = sorted_entries(folder);
  return std::any_of(files.begin(), files.end(), is_scene);
}

}  // namespace

std::vector<RobotInScene> read_robots() {
  std::vector<RobotInScene> robots;
  for (const Path& folder : sorted_entries(TREELINE_ROBOTS_DIR)) {
    if (!is_of_a_robot(folder)) continue;
    const std::string name = folder.filename().string();
    Diagnostics diagnostics;
    const auto robot = read_urdf((folder / (name + ".urdf")).string(), diagnostics);
    if (!robot) fail(diagnostics);
    for (const Path& file : sorted_entries(folder)) {
      if (!is_scene(file)) continue;
      const auto scene = read_scene(file.string(), *robot, diagnostics);
      if (!scene) fail(diagnostics);
      robots.push_back({name + "/" + file.stem().string(), *robot, *scene});
    }
  }
  return robots;
}

}  // namespace treeline::tests
