#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/surroundings.hpp"
#include "functions/function.hpp"

namespace treeline {

/// A number of a file, or a relation between several, that is taken as exact.
struct NoiseDecision {
  std::string file;
  int line = 0;         ///< 1-based; 0 when unknown
  std::string element;  ///< e.g. `robot/joint[elbow]/origin`
  std::string text;     ///< e.g. `roll 1.1e-27 rad is 0`
  double change = 0;    ///< by how much, rad or m; of inertias, share of the moments
};
using NoiseDecisions = std::vector<NoiseDecision>;

/// Limits against slipping, turning, tipping and lifting of a constraint. To the world, its normal
/// is the z axis of the constraint's axes and its forces are those of the world on the robot.
/// Between two links, its normal is z of `other_origin`, along which the second pushes the first.
struct SceneCone {
  std::string constraint;
  double friction = 0;              ///< largest ratio of tangential to normal force
  int sides = 4;                    ///< of the pyramid within the cone of friction: 4 or 8
  double least_force = 0;           ///< along the normal, N
  std::optional<double> torsional;  ///< largest ratio of the moment about z to the normal force, m
  /// Half lengths along x and y within which the centre of pressure stays, m.
  std::optional<std::array<double, 2>> half_extents;
};

enum class Base { fixed, floating };
enum class Axes { world, local };
enum class Real { float32, float64 };
/// Language of the emitted code: C++17, C99 or OpenCL C 1.2.
enum class Language { cpp, c, opencl };
/// How the emitted code is written: as compilers like it best, or as rules for safe code ask.
enum class Profile { plain, misra };
/// Preference for speed, or for size at the cost of time.
enum class Optimize { speed, size };
/// Whether functions compute the sines and cosines of q or take them as arguments.
enum class Sines { computed, given };
/// Preference where operations can be saved at the cost of digits.
enum class Accuracy { best, balanced, fastest };

/// Answer of functions where rows of a task cannot be moved. With `smooth` a row yields (see
/// `TaskLaw`), with `early` somewhat farther from there. With `exact` a bare solve
/// gives values that are not finite there.
enum class SingularTasks { smooth, exact, early };

/// A frame fixed to a link: an operational point, or the place where an external force acts.
/// `axes` are those in which its rows (linear over angular) are expressed; the reference point is
/// always the frame's origin. `axes: world` means the world's axes. An operational point may be the
/// centre of mass of everything in the scene, with rows of translation in world axes and no link.
struct ScenePoint {
  std::string name;
  std::string link;
  Pose origin;
  Axes axes = Axes::world;
  std::array<bool, 6> rows{true, true, true, true, true, true};  ///< x y z rx ry rz
  int priority = 1;  ///< of an operational point's task: 1 comes first; equal ones share a level
  bool center_of_mass = false;
};

inline bool is_center_of_mass(const ScenePoint& point) {
  return point.center_of_mass;
}

/// A wheel or ball around a frame's origin that rolls without slipping on the plane z = 0 of
/// another frame, or on a ball around that frame's origin.
struct SceneRolling {
  double radius = 0;                          ///< m
  std::optional<std::array<double, 3>> axis;  ///< of a disc that may lean; absent: a ball
  std::optional<double> on_radius;            ///< of the other ball, m; negative: of a bowl
};

/// The second link of a loop that is closed by the world.
inline constexpr const char* kWorldEnd = "world";

/// Two frames of the robot of which rows are held relative to each other, so that a loop closes.
/// Rows are along the axes of the second frame, which also says which: x, y, z of the first frame's
/// origin seen from the second, and small turns of the first frame. Where it rolls, x, y, z are
/// those of the point of the first link at the contact, and only their velocities are held but for
/// the one along the normal. Rolling on the world has the second link `kWorldEnd`.
struct SceneLoop {
  ScenePoint first, second;
  std::optional<SceneRolling> rolling = {};
};

/// A linear relation that velocities of joints keep: sum of `factor` times q + `offset` = 0, in the
/// units of the joints.
struct SceneCoupling {
  struct Part {
    std::string joint;
    double factor = 1;
  };
  std::string name;
  std::vector<Part> parts;
  double offset = 0;
};

/// Whether the points differ in priority: then `control_torque` obeys it.
inline bool has_priorities(const std::vector<ScenePoint>& points) {
  for (const ScenePoint& point : points) {
    if (point.priority != points.front().priority) return true;
  }
  return false;
}

/// A hand that holds an object rigidly: an operational point, and the object's frame seen from it.
/// The point's rows and axes play no part.
struct SceneGrasp {
  std::string point;
  Pose origin;
};

/// A rigid body in one or several hands. Mass in kg, inertia about the centre of mass in the axes
/// of the object's frame, in which `inertial.origin` has the centre.
struct SceneObject {
  std::string name;
  Inertial inertial;
  std::vector<SceneGrasp> grasps;  ///< at least one; the first says where the object is
};

/// A link whose ten inertial parameters are an argument: those of a body added to it, or its own.
/// Rounding bounds hold for matter of up to `mass` (kg) within `reach` (m) of the link's origin.
struct SceneInertia {
  std::string link;
  double mass = kPayloadMass;
  double reach = kPayloadReach;
};

/// An operational point or a contact whose origin in its link's frame is an argument. Rounding
/// bounds hold for components of up to `reach` (m).
struct SceneTool {
  std::string point;
  double reach = info_of(Quantity::tool).range;
  bool orientation = false;  ///< of an operational point: its axes are an argument, too
};

/// Model data that is passed at run time: properties of the robot and its surroundings that change
/// while the robot runs.
struct SceneInputs {
  bool gravity = false;
  std::vector<SceneInertia> payloads;    ///< bodies that are added to links
  std::vector<SceneInertia> parameters;  ///< in place of those of the URDF
  bool base_parameters = false;          ///< in place of the parameters of all links
  std::vector<SceneTool> tools;     ///< operational points, in place of the origins in the scene
  std::vector<SceneTool> contacts;  ///< contacts, in place of the origins in the scene
  std::vector<std::string> active;  ///< constraints that come and go
  std::vector<std::string> active_tasks;  ///< operational points whose tasks come and go

  [[nodiscard]] bool empty() const {
    return !gravity && payloads.empty() && parameters.empty() && !base_parameters &&
           tools.empty() && contacts.empty() && active.empty() && active_tasks.empty();
  }
};

/// A motor's rotor that is a body of its own: it turns `ratio` times as fast as its joint, on the
/// link before the joint unless `link` names another. Its mass and its moments across the axis are
/// part of that link.
struct SceneRotor {
  double inertia = 0;  ///< kg m^2 about its axis
  double ratio = 1;    ///< turns of the rotor for one of the joint; rad/m of a sliding joint
  std::string link;
  /// Axis of the rotor, unit length, in the axes of the link that carries it; absent: the joint's.
  std::optional<std::array<double, 3>> axis;
};

/// Speed within which Coulomb friction builds up unless a scene says another, rad/s or m/s.
inline constexpr double kFrictionWidth = 0.01;

/// Friction of a joint: damping qd + friction s(qd / width), where s is a smooth sign.
struct SceneFriction {
  double damping = 0;   ///< N m s/rad, or N s/m
  double friction = 0;  ///< Coulomb friction, N m or N
  double width = 0;     ///< speed within which it builds up, rad/s or m/s; positive with friction
};

/// Spring of a joint: the joint force that holds it at q is stiffness (q - rest).
struct SceneSpring {
  double stiffness = 0;  ///< N m/rad, or N/m
  double rest = 0;       ///< rad or m
};

/// The parameters whose columns regressors have: of each link the ten inertial ones, or of all that
/// there are the base parameters, on which the motion depends, see `find_base_parameters`.
struct SceneRegressor {
  bool base = false;
  bool none = false;                  ///< no inertial parameters of links
  std::vector<std::string> links;     ///< whose columns there are; empty: all that move
  std::vector<std::string> payloads;  ///< links, with the ten of a body added to each
  bool rotors = false;                ///< and the rotor inertia of each joint of one freedom
  bool friction = false;              ///< and the viscous friction of each such joint
  bool coulomb = false;               ///< and the Coulomb friction of each such joint
  /// Width of Coulomb friction, rad/s or m/s, of joints for which `joint_friction` states none.
  double width = kFrictionWidth;

  bool operator==(const SceneRegressor&) const = default;
};

/// The effective masses beyond which a direction of the task yields near singularities: kg in rows
/// of translation, kg m^2 in rows of rotation. See `core::damped_solve`.
struct EffectiveMassLimit {
  double mass = 0;
  double inertia = 0;
};

/// Limits of a joint in the controller, in place of the URDF's: rad or m, rad/s or m/s, N m or N.
/// Infinite where the scene waives one.
struct SceneJointLimits {
  std::optional<double> lower, upper, speed, torque;
};

/// A joint's motor and gear: the controller's torque as a current.
struct SceneMotor {
  double ratio = 1;     ///< turns of the motor for one of the joint; rad/m of a sliding joint
  double constant = 0;  ///< torque of the motor per current, N m/A
  double current = 0;   ///< largest current, A; 0: no limit of its own
};

/// A set of operational points whose tasks are done, of those that come and go.
struct SceneBehaviour {
  std::string name;  ///< an identifier
  std::vector<std::string> tasks;
};

/// The controller to emit, `NAME_step`. All numbers are defaults of its configuration.
struct SceneController {
  bool task = false;            ///< has the law of tasks beside that of joints
  bool force = false;           ///< and forces along a direction
  bool clamps = false;          ///< cuts each torque by itself in place of scaling all
  double period = 1e-3;         ///< s, between two steps
  double joint_frequency = 20;  ///< rad/s: stiffness is its square, 1/s^2
  double task_frequency = 20;
  double posture_frequency = 5;
  double damping_ratio = 1;
  double brake_damping = 20;      ///< 1/s, of the reference along which the robot is braked
  double hold_frequency = 60;     ///< rad/s: how stiffly it is led along that, and held
  double hold_reach = 0.05;       ///< rad or m that the reference leaves a joint behind
  double observer = 0;            ///< rad/s, of one that finds velocities; 0: they are measured
  double jump = 0.05;             ///< rad or m of q that qd does not explain
  double following = 0.3;         ///< rad or m that a reference may be away
  double speed_rise = 0.15;       ///< s in which a reference may rise from rest to its limit
  int speed_rise_line = 0;        ///< of the scene that states it; 0: none does
  double torque_rise = 0.025;     ///< s in which a torque may rise from 0 to its limit
  double point_speed = 1.5;       ///< m/s of a point along its reference
  double point_turn = 3;          ///< rad/s
  double position_margin = 0.05;  ///< rad or m beyond a limit that are a fault
  double speed_margin = 0.1;      ///< share of a limit
  double fade = 0.1;              ///< s, of a switch between laws
  double force_gain = 0.05;       ///< 1/kg: one over the mass that moves under what is missing
  double force_rate = 2;          ///< 1/s, of the integral
  double force_damping = 60;      ///< 1/s
  double largest_force = 50;      ///< N
  int stale_ticks = 200;          ///< steps without a command that are a fault; 0: never
  int blind_ticks = 100;          ///< steps that gravity is held without a measurement
  std::map<std::string, SceneJointLimits> limits;  ///< by joint
  std::map<std::string, SceneMotor> motors;        ///< by joint: of all or of none
  std::vector<SceneBehaviour> behaviours;          ///< the first is what it begins with
};

/// Choices for the code of one robot; every key but `operational_points` has a default.
struct Scene {
  std::string file;
  std::string name;  ///< identifier: namespace and folder of the emitted code
  Base base = Base::fixed;
  std::array<double, 3> gravity{0, 0, -9.81};  ///< m/s^2, world axes
  std::vector<ScenePoint> operational_points;
  std::vector<ScenePoint> external_forces;  ///< [force; moment] inputs; always all six rows
  std::vector<ScenePoint> contacts;         ///< rows x y z in world axes
  std::vector<SceneObject> objects;
  SceneInputs inputs;
  SceneRegressor regressor;
  /// Frames whose `rows` are held relative to the world: feet on the ground, hands on a wall.
  std::vector<ScenePoint> constraints;
  std::vector<SceneCone> cones;          ///< of constraints whose forces are limited
  std::vector<SceneLoop> loops;          ///< constraints between two links
  std::vector<SceneCoupling> couplings;  ///< constraints between joints
  /// Names of joints without a motor. The floating base and floating joints never have one.
  std::vector<std::string> passive;
  std::vector<Function> functions;  ///< sorted, unique
  Real real = Real::float64;
  Language language = Language::cpp;
  Profile profile = Profile::plain;
  Optimize optimize = Optimize::speed;
  int selftest = 0;  ///< states in which NAME_selftest calls each function; 0: there is none
  Sines sin_cos = Sines::computed;
  Accuracy accuracy = Accuracy::balanced;
  /// Angles of the files that are quarter turns rounded to a few digits are taken as exact
  /// where they are at most so far off, rad; 0: every angle is as written. See
  /// `rounded_quarter_turns`.
  double snap_angles = 0;
  /// Numbers of the files that are so close to an exact one, and relations between them, are taken
  /// as exact: angles in rad, offsets as a share of the robot's longest; 0: every number is as
  /// written. See `noise_limits`.
  double noise = 0x1p-51;
  NoiseDecisions taken_exact;  ///< numbers of this file that reading has made so, as `noise` asks
  /// Numbers that the emitted code may compute together: 1, 2, 4 or 8. What a machine's registers
  /// cannot hold its compiler takes apart again.
  int lanes = 8;
  bool asks_for_lanes = false;     ///< by the scene's author; else they follow language and target
  std::string target = "generic";  ///< processor that the code is for, see `find_target`
  int batch = 0;  ///< states that the functions of NAME_batch.hpp take in one call; 0: none emitted
  SingularTasks singular = SingularTasks::smooth;
  std::optional<EffectiveMassLimit> damped;   ///< asks for NAME_damped.hpp: damped_control_torque
  std::optional<SceneController> controller;  ///< asks for NAME_controller.h
  std::optional<SceneGround> ground_step;     ///< the ground, where it asks for NAME_ground.h
  std::vector<SceneTouch> touches;            ///< of the robot, where there is such a ground
  /// Joint name -> inertia that its motor's rotor adds to the joint, kg m^2 (kg for sliding
  /// joints).
  std::map<std::string, double> armature;
  std::map<std::string, SceneRotor> rotors;             ///< by joint, in place of its armature
  std::map<std::string, SceneFriction> joint_friction;  ///< by joint, where there is any
  bool implicit_friction = false;  ///< forward dynamics takes drives at the end of a step
  std::map<std::string, SceneSpring> joint_springs;  ///< by joint
  /// By joint, largest torque of its motor, N m or N.
  std::map<std::string, double> torque_limits;
  bool torque_limits_of_urdf = false;    ///< they are the efforts that the URDF states
  std::map<std::string, double> locked;  ///< joint name -> value it is held at

  /// Whether NAME_limited.hpp is asked for: limited_control_torque.
  [[nodiscard]] bool has_limits() const { return !cones.empty() || !torque_limits.empty(); }
  void remove_limits() {
    cones.clear();
    torque_limits.clear();
  }

  [[nodiscard]] bool holds_rows() const {
    return !constraints.empty() || !loops.empty() || !couplings.empty();
  }
};

}  // namespace treeline
