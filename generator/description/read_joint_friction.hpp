#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// The smooth sign of Coulomb friction is above 0.995 from 3 to this many times its width; beyond
/// it falls off (see `smooth_sign`).
inline constexpr double kWidestRatio = 5461;

/// The scene's `joint_friction`: `none`, `viscous`, `coulomb`, or a map of `model` (viscous or
/// coulomb), `width` (of coulomb, rad/s or m/s, by default 0.01), `implicit` (false) and `joints`,
/// a map from joints to `{damping, friction, width}` in place of what the URDF's `<dynamics>` says,
/// N m s/rad and N m, or N s/m and N. Fills `Scene::joint_friction` for joints of one degree of
/// freedom that move. An error for coefficients that are negative, that the model does not have, or
/// that nobody states, and for a width so small that friction falls off below the joint's velocity
/// limit. A note of what the model leaves out.
void read_joint_friction(const SceneElement& element, const Robot& robot, Scene& scene);

/// A note where the file states damping or friction, of which the scene says nothing.
void note_unused_friction(const SceneElement& top, const Robot& robot);

}  // namespace treeline
