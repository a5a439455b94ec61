#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// The scene's `joint_springs`: a map from joints to `{stiffness, rest}`, N m/rad and rad, or N/m
/// and m; rest by default 0. `implicit: true` beside them is that of `joint_friction`. An error for
/// a joint that is unknown, fixed, locked or of several degrees of freedom, and for a stiffness
/// that is missing or not positive.
void read_joint_springs(const SceneElement& element, const Robot& robot, Scene& scene);

/// A note where the file states springs, of which the scene says nothing.
void note_unused_springs(const SceneElement& top, const Robot& robot);

}  // namespace treeline
