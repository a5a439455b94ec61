#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// The robot with a link for each of `Scene::rotors`, behind a joint that follows the one it drives
/// (`Joint::spins`). So its inertia, its gyroscopic moments and its coupling with the motion of the
/// link that carries it are those of any link (RBDA section 9.6). Its names are those of the joint
/// it drives, with `_rotor`.
Robot with_rotors(Robot robot, const Scene& scene);

}  // namespace treeline
