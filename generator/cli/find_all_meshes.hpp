#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/read_inputs.hpp"
#include "cli/read_robot_files.hpp"
#include "description/scene.hpp"
#include "drive/find_meshes.hpp"
#include "simulation/ground.hpp"
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

/// Reads what of a robot may touch the ground: the `<collision>` of its links. `body` of each is
/// left to who has a model. A mesh is some of its outermost corners; meshes that are missing or
/// cannot be read are a warning.
std::vector<simulation::GroundShape> read_ground_shapes(const RobotFiles& files,
                                                        const drive::MeshPlaces& places,
                                                        Diagnostics& diagnostics);

/// Reads what may touch the ground, where a scene asks for a step on it. Errors: what such a step
/// does not have. Meshes that are missing are a warning.
void complete_ground_step(const RobotWithFiles& read, Scene& scene, Diagnostics& diagnostics);

/// Reads what of a robot may touch the ground. Meshes that are missing are a warning.
std::vector<SceneTouch> read_touches(const RobotFiles& files, const drive::MeshPlaces& places,
                                     Diagnostics& diagnostics);

}  // namespace treeline
