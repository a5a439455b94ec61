#pragma once

#include <vector>

#include "cli/read_robot_files.hpp"
#include "drive/find_meshes.hpp"
#include "simulation/ground.hpp"

namespace treeline {

/// Reads what of a robot may touch the ground: the `<collision>` of its links. `body` of each is
/// left to who has a model. A mesh is some of its outermost corners; meshes that are missing or
/// cannot be read are a warning.
std::vector<simulation::GroundShape> read_ground_shapes(const RobotFiles& files,
                                                        const drive::MeshPlaces& places,
                                                        Diagnostics& diagnostics);

}  // namespace treeline
