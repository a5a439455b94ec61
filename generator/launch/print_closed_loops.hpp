#pragma once

#include <string>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Whether constraints hold the robot to the world, so that its base needs no ideal forces.
bool is_held_to_world(const Scene& scene);

/// Whether the robot's dynamics are those of `drive::ClosedLoops`.
inline bool is_closed(const Scene& scene) {
  return scene.holds_rows();
}

/// Velocities without a motor: of `passive` joints, and of a floating base that is held to the
/// world.
std::vector<int> unmotored_velocities(const Scene& scene, const Mechanism& mechanism);

/// Members of a driven robot whose loops are closed or that is held to the world, beside those of
/// its tree. `links` is the scene of its links' frames.
std::string print_closed_loops(const Scene& control, const Mechanism& mechanism,
                               const Scene& links);

}  // namespace treeline
