#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The scene that the control loop's code is generated for: points, base, gravity and locked joints
/// as in `scene`, but in double, with the functions that the loop calls, and without what it does
/// not: objects, contacts, external forces, batches, given sines. A note tells what is left out.
/// Loops that close between links, and couplings, stay. Errors: nothing moves; the robot cannot be
/// simulated; it is held to the world.
Scene control_scene(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

/// The scene for pulling at links: each is a point where a force acts and where its frame is
/// computed. Its points are empty where pulling is not possible: too many links.
Scene link_scene(const Robot& robot, const Scene& control);

/// The scene of the simulated robot on a ground: a step of time on it, of the robot that nothing
/// holds, with the shapes of `control` that may touch it. Errors: what such a step does not have;
/// a floating base for which no constraint says where it stands.
Scene ground_scene(const Robot& robot, const Scene& control, const SceneGround& ground,
                   Diagnostics& diagnostics);

/// Gives a scene without `damped` one that suits the robot, with a note, so that its task yields
/// near singularities: directions that feel heavier than six times what moves, in rotations at an
/// eighth of the robot's reach. Tasks with priorities or `singular: exact` are left as they are.
void assume_damping(const Robot& robot, Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
