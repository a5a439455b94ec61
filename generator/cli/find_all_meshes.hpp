#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/read_inputs.hpp"
#include "drive/find_meshes.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Options of the command line about meshes.
struct MeshOptions {
  std::vector<std::string> packages;  ///< NAME=DIR, each
  std::vector<std::string> folders;
};

/// Adds `--package` and `--mesh-folder`.
void add_mesh_options(CLI::App& command, MeshOptions& options);

/// Places in which meshes may lie, from the options and from AMENT_PREFIX_PATH and
/// ROS_PACKAGE_PATH. Errors: what is no folder.
std::optional<drive::MeshPlaces> read_mesh_places(const MeshOptions& options,
                                                  Diagnostics& diagnostics);

/// The meshes of all robots. Those of several are named as `print_joined_urdf` names them.
std::vector<drive::ServedMesh> find_all_meshes(const RobotFiles& files,
                                               const drive::MeshPlaces& places);

/// Tells of meshes that are missing, and so not `verb`, "shown" for instance: the first, and how
/// many others.
void warn_of_missing(const std::vector<drive::ServedMesh>& meshes, const std::string& verb,
                     Diagnostics& diagnostics);

}  // namespace treeline
