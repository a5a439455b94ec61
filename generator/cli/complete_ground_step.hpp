#pragma once

#include <vector>

#include "cli/read_robot_files.hpp"
#include "description/scene.hpp"
#include "drive/find_meshes.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Reads what may touch the ground, where a scene asks for a step on it. Errors: what such a step
/// does not have. Meshes that are missing are a warning.
void complete_ground_step(const RobotWithFiles& read, Scene& scene, Diagnostics& diagnostics);

/// Reads what of a robot may touch the ground. Meshes that are missing are a warning.
std::vector<SceneTouch> read_touches(const RobotFiles& files, const drive::MeshPlaces& places,
                                     Diagnostics& diagnostics);

}  // namespace treeline
