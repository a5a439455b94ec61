#include "cli/find_all_meshes.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// The folders of a variable such as PATH. Relative ones are nobody's consent.
std::vector<fs::path> folders_of(const char* variable) {
  const char* const value = std::getenv(variable);
  std::vector<fs::path> folders;
  std::istringstream parts(value != nullptr ? value : "");
  for (std::string part; std::getline(parts, part, ':');) {
    if (fs::path(part).is_absolute()) folders.emplace_back(part);
  }
  return folders;
}

}  // namespace

void add_mesh_options(CLI::App& command, MeshOptions& options) {
  command.add_option("--package", options.packages,
                     "NAME=DIR: where package://NAME/ lies; else beside the URDF, and in "
                     "$AMENT_PREFIX_PATH and $ROS_PACKAGE_PATH");
  command.add_option("--mesh-folder", options.folders,
                     "DIR: meshes below it are shown, also where the URDF names them by ../, by an "
                     "absolute path or by file://");
}

std::optional<drive::MeshPlaces> read_mesh_places(const MeshOptions& options,
                                                  Diagnostics& diagnostics) {
  drive::MeshPlaces places;
  for (const std::string& package : options.packages) {
    const std::size_t equals = package.find('=');
    if (equals != std::string::npos && fs::is_directory(package.substr(equals + 1))) {
      places.packages[package.substr(0, equals)] = package.substr(equals + 1);
      continue;
    }
    diagnostics.add({Severity::error, "", 0, "--package",
                     fmt::format("\"{}\" is not NAME=DIR with a folder that exists", package),
                     "name the folder that package://NAME/ stands for"});
  }
  for (const std::string& folder : options.folders) {
    if (fs::is_directory(folder)) {
      places.folders.emplace_back(folder);
      continue;
    }
    diagnostics.add({Severity::error, "", 0, "--mesh-folder",
                     fmt::format("\"{}\" is no folder", folder),
                     "name a folder whose meshes may be shown"});
  }
  places.prefixes = folders_of("AMENT_PREFIX_PATH");
  places.sources = folders_of("ROS_PACKAGE_PATH");
  if (diagnostics.has_errors()) return std::nullopt;
  return places;
}

std::vector<drive::ServedMesh> find_all_meshes(const RobotFiles& files,
                                               const drive::MeshPlaces& places) {
  const auto folder = [](const std::string& path) { return fs::path(path).parent_path(); };
  if (!files.urdf.empty()) {
    return drive::find_meshes(files.urdf_text, folder(files.urdf), places);
  }
  const SceneRobots& listed = files.scene_robots;
  std::vector<drive::ServedMesh> meshes;
  for (std::size_t i = 0; i < listed.robots.size(); ++i) {
    const InputFile& file = listed.files[listed.file_of_robot[i]];
    for (auto& mesh : drive::find_meshes(file.text, folder(file.path), places)) {
      mesh.uri.insert(0, listed.robots[i].name + "/");
      meshes.push_back(std::move(mesh));
    }
  }
  return meshes;
}

void warn_of_missing(const std::vector<drive::ServedMesh>& meshes, const std::string& verb,
                     Diagnostics& diagnostics) {
  const auto is_missing = [](const drive::ServedMesh& mesh) { return mesh.path.empty(); };
  const auto first = std::ranges::find_if(meshes, is_missing);
  if (first == meshes.end()) return;
  const auto count = std::ranges::count_if(meshes, is_missing);
  diagnostics.add({Severity::warning, "", 0, first->uri,
                   fmt::format("this mesh is not {}{}: {}", verb,
                               count > 1 ? fmt::format(", and {} others are not", count - 1) : "",
                               first->problem),
                   first->remedy});
}

}  // namespace treeline
