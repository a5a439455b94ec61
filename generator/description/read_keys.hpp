#pragma once

#include <string>
#include <vector>

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

/// The scene's list of frames of which rows are held: `between: [link, world]` relative to the
/// world, `between: [link, other link]` relative to a frame of another link, which closes a loop.
/// `rolling` lets the first frame roll on the other one.
void read_constraints(const SceneElement& element, const Robot& robot, Scene& scene);

/// The loops that the robot's file closes, as constraints.
void add_loops_of_robot(const Robot& robot, Scene& scene);

/// The scene's list of linear relations between joints. An error for a joint that is unknown,
/// fixed, locked, mimic or of several degrees of freedom.
void read_couplings(const SceneElement& element, const Robot& robot, Scene& scene);

/// Reads `rolling: {radius, axis, on_radius}` of a constraint into the loop, whose rows are those
/// that `fields` list, or x y z.
void read_rolling(const SceneFields& fields, SceneLoop& loop);

/// The keys of a constraint that limit its forces.
inline constexpr std::array kConeKeys = {"friction", "torsional", "half_extents", "sides",
                                         "least_force"};

/// Reads the limits of the forces of a constraint to the world, if it has some, into `scene`.
void read_support_cone(const SceneElement& item, const SceneFields& fields, const ScenePoint& held,
                       Scene& scene);

/// Reads `motors` of a controller: of each joint its gear, the constant of its motor, and perhaps
/// the largest current.
void read_motors(const SceneElement& element, const Robot& robot, const Scene& scene,
                 SceneController& controller);

/// Reports as an error a joint whose motor is not listed where others are: its current would be
/// told by nobody.
void check_motors(const SceneElement& top, const Robot& robot, const Scene& scene);

/// The controller's `behaviours`: by name the operational points whose tasks are done, of those
/// that `inputs: active` lists. Errors: points that are not there, names that are no identifiers or
/// the same in capitals.
void read_behaviours(const SceneElement& element, const Scene& scene, SceneController& controller);

/// Reports as an error behaviours without a law of tasks, and tasks that come and go in a
/// controller without behaviours: nothing would ever do them.
void check_behaviours(const SceneElement& top, const Scene& scene);

/// The scene's `controller`: laws, period, gains and limits of the controller to emit. Errors: no
/// law, a law twice, numbers that no controller can have, frequencies that the period cannot
/// follow, limits of a joint that is unknown or has no coordinate of its own.
void read_controller(const SceneElement& element, const Robot& robot, Scene& scene);

/// What keeps a joint from being driven as one number by a motor: "joint "wrist" is passive"; empty
/// where all joints can be.
std::string find_unfit_joint(const Robot& robot, const Scene& scene);

/// Functions that the scene's controller contains beside those that the scene asks for; none
/// without a controller.
std::vector<Function> list_controller_functions(const Scene& scene);

/// Reports as an error what of the robot and the rest of the scene does not permit the controller
/// that is asked for. Every coordinate needs a motor and a number of its own: no floating base, no
/// ball joint, nothing passive, no closed loop; and limits, see `check_controller_limits`. Laws of
/// tasks need operational points and the inverse of the mass matrix: `singular` names what has no
/// mass beyond it, if anything.
void check_controller(const SceneElement& top, const Robot& robot, const std::string& singular,
                      const Scene& scene);

/// A key at the top of a scene.
struct SceneKey {
  const char* name;
  /// Reads its value into the scene. Null for what other readers take from the file: robots,
  /// ground, obstacles and avoidance.
  void (*read)(const SceneElement& value, const Robot& robot, Scene& scene) = nullptr;
  /// Notes for a scene without the key, if there are any.
  void (*note_absence)(const SceneElement& top, const Robot& robot) = nullptr;
};

/// Every key that a scene may have, in the order in which they are read.
const std::vector<SceneKey>& scene_keys();

/// Whether the controller has a motor of its own for a joint.
bool is_driven(const Joint& joint, const Scene& scene);

/// Limits of a joint in the controller: those that the scene states or waives there, else the
/// URDF's. A motor whose current is limited has no more torque than that gives.
Limits limits_in_controller(const Joint& joint, const SceneController& controller);

/// Reports as an error what the controller has no limit of that a file states and the scene does
/// not waive: positions of joints that have ends, speeds, torques. It guards by nothing else. So
/// it reports ends of which one is the scene's, that leave no position between them.
void check_controller_limits(const SceneElement& top, const Robot& robot, const Scene& scene);

}  // namespace treeline
