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

/// The file of a folder's own robot. Other folders have programs, or scenes of robots that others
/// publish.
Path own_urdf(const Path& folder) {
  return folder / (folder.filename().string() + ".urdf");
}

}  // namespace

std::vector<RobotInScene> read_robots() {
  std::vector<RobotInScene> robots;
  for (const Path& folder : sorted_entries(TREELINE_ROBOTS_DIR)) {
    if (!std::filesystem::exists(own_urdf(folder))) continue;
    const std::string name = folder.filename().string();
    Diagnostics diagnostics;
    const auto robot = read_urdf(own_urdf(folder).string(), diagnostics);
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
