#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// The scene's list of frames of which rows are held: `between: [link, world]` relative to the
/// world, `between: [link, other link]` relative to a frame of another link, which closes a loop.
/// `rolling` lets the first frame roll on the other one.
void read_constraints(const SceneElement& element, const Robot& robot, Scene& scene);

/// The loops that the robot's file closes, as constraints.
void add_loops_of_robot(const Robot& robot, Scene& scene);

/// The scene's list of linear relations between joints. An error for a joint that is unknown,
/// fixed, locked, mimic or of several degrees of freedom.
void read_couplings(const SceneElement& element, const Robot& robot, Scene& scene);

}  // namespace treeline
