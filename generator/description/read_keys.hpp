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

/// The scene's `joint_springs`: a map from joints to `{stiffness, rest}`, N m/rad and rad, or N/m
/// and m; rest by default 0. `implicit: true` beside them is that of `joint_friction`. An error for
/// a joint that is unknown, fixed, locked or of several degrees of freedom, and for a stiffness
/// that is missing or not positive.
void read_joint_springs(const SceneElement& element, const Robot& robot, Scene& scene);

/// A note where the file states springs, of which the scene says nothing.
void note_unused_springs(const SceneElement& top, const Robot& robot);

/// Reads which columns regressors have: `parameters: all`, `base` or `none`, `links`, `payload`,
/// `rotors`, `friction: viscous` (`true`) or `coulomb`, `width`. An error for links that are
/// unknown, fixed to another or at rest, and for links or payloads together with base parameters.
/// Joints that the scene locks must have been read.
void read_regressor(const SceneElement& element, const Robot& robot, Scene& scene);

/// Warns of the key `regressor` where no function has a regressor.
void check_regressor_used(const SceneElement& top, const Scene& scene);

/// The scene's list of objects into `scene.objects`: names that are identifiers and differ, a mass
/// and an inertia that a body can have, grasps by operational points, each of which holds one
/// object at most. `scene.operational_points` has been read.
void read_objects(const SceneElement& element, Scene& scene);

/// Reads the largest torques of motors, `urdf` or a map from joint to number, into
/// `scene.torque_limits`.
void read_torque_limits(const SceneElement& element, const Robot& robot, Scene& scene);

/// Reads what of the robot functions take as arguments: `gravity`, `payload`, `parameters`,
/// `base_parameters`, `tool`, `contact`. An error for links that are unknown or cannot move, and
/// for points that are unknown or hold an object. Everything else of the scene must have been read.
void read_scene_inputs(const SceneElement& element, const Robot& robot, Scene& scene);

/// Warns of what the scene lists under `inputs` and none of its functions depends on.
void check_inputs_used(const SceneElement& top, const Scene& scene);

}  // namespace treeline
