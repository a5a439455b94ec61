#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// The scene's `armature`: `none`, `file` (what the URDF says of rotors), or a map from joints to
/// numbers (kg m^2, kg for sliding joints, at the joint) or to `{rotor_inertia, gear_ratio}`, the
/// ratio by default that of the file. With `gyroscopic: true`, and `link` and `axis` where it does
/// not sit on the link before the joint, a rotor is one of `Scene::rotors`. An error for a joint
/// that is unknown, fixed, locked or of several degrees of freedom, and for a negative inertia.
void read_armature(const SceneElement& element, const Robot& robot, Scene& scene);

/// A note where the file states rotors, of which the scene says nothing.
void note_unused_rotors(const SceneElement& top, const Robot& robot);

}  // namespace treeline
