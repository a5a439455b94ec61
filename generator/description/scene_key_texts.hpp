#pragma once

#include <array>

namespace treeline {

/// Text about a key at the top of a scene: for `treeline keys`, and for the documentation, which is
/// made from it.
struct SceneKeyText {
  const char* name;
  const char* type;      ///< of its value
  const char* fallback;  ///< what holds in a scene without the key
  const char* example;   ///< lines of a scene
  const char* meaning;   ///< with its units
  const char* page;      ///< of the documentation, from its folder; null: this text says all
};

/// One for every key, in the order in which people look for them: the robot, what it moves and
/// touches, what is in its joints, the functions, the code.
inline constexpr auto kSceneKeyTexts = std::to_array<SceneKeyText>({
    {"name", "identifier", "the robot's name", "name: arm",
     "Namespace and folder of the generated code.", nullptr},
    {"base", "`fixed` or `floating`", "`fixed`; `floating` if no joint moves", "base: floating",
     "Whether the root link is held by the world. A floating base has seven coordinates and six "
     "velocities, and no motor.",
     "reference/conventions.md"},
    {"gravity", "three numbers, m/s²", "`[0, 0, -9.81]`", "gravity: [0, 0, -1.62]",
     "Acceleration of gravity in world axes. It is folded into the code; `inputs` makes it an "
     "argument.",
     "how-to/gravity.md"},
    {"robots", "list of `name`, `urdf`, `pose: {xyz, rpy}`, `base`", "the robot of the command",
     "robots:\n"
     "  - {name: left, urdf: ur10e.urdf}\n"
     "  - {name: right, urdf: ur10e.urdf, pose: {xyz: [1.4, 0, 0]}}",
     "Several robots in one scene, in place of a URDF on the command line. Paths are relative to "
     "the scene's folder; links and joints are `NAME/link` and `NAME/joint`.",
     "how-to/second-arm.md"},
    {"operational_points",
     "list of `name`, `link` or `center_of_mass: true`, `origin: {xyz, rpy}`, `rows`, `axes`, "
     "`priority`",
     "none",
     "operational_points:\n"
     "  - {name: tool, link: link6, origin: {xyz: [0, 0, 0.1]}, rows: [x, y, z]}",
     "Points to control. `rows` are out of `x y z rx ry rz` in this order, all unless given; "
     "`axes` are `world`, the default, or `local`; `priority` is 1, the default and the first, "
     "to 1000. With `center_of_mass: true` in place of a link the point is the centre of mass of "
     "everything, with rows out of `x y z`.",
     "how-to/tool-frame.md"},
    {"external_forces", "list of `name`, `link`, `origin`, `axes`", "none",
     "external_forces:\n"
     "  - {name: sensor, link: link6}",
     "Points where external forces act. Functions get an input `f_ext`: force over moment on the "
     "robot at each.",
     nullptr},
    {"contacts", "list of `name`, `link`, `origin`", "none",
     "contacts:\n"
     "  - {name: fingertip, link: link6, origin: {xyz: [0, 0, 0.1]}}",
     "Points where impulses act.", "explanation/contact.md"},
    {"constraints", "list of `name`, `between`, `origin`, and `rows`, `contact` or `rolling`",
     "none",
     "constraints:\n"
     "  - {name: foot, between: [link6, world], rows: [x, y, z]}",
     "Frames that are held relative to the world or to another link: feet on the ground, closed "
     "loops, contacts, wheels. Also `other_origin`, `axes`, and the limits of a contact's "
     "forces: "
     "`friction`, `sides`, `torsional`, `half_extents`, `least_force`.",
     "explanation/contact.md"},
    {"couplings", "list of `name`, `joints: {JOINT: factor}`, `offset`", "none",
     "couplings:\n"
     "  - {name: belt, joints: {joint5: 1, joint6: -1}}",
     "Linear relations between joints, such as belts and differentials: the sum of factor times "
     "coordinate, plus the offset, is held at 0.",
     "how-to/closed-loop.md"},
    {"passive", "list of joints", "none", "passive: [joint6]",
     "Joints without a motor. The six freedoms of a floating base or joint never have one; a "
     "mimic "
     "joint has the motor of the joint that it follows.",
     "explanation/contact.md"},
    {"objects",
     "list of `name`, `mass`, `center`, `inertia: {ixx, iyy, izz, ixy, ixz, iyz}`, `grasps: "
     "[{point, origin}]`, `shapes: [{box or sphere, origin}]`",
     "none",
     "objects:\n"
     "  - name: box\n"
     "    mass: 4\n"
     "    inertia: {ixx: 0.05, iyy: 0.1, izz: 0.12}\n"
     "    grasps: [{point: tool, origin: {xyz: [0, 0, 0.1]}}]",
     "Rigid objects that hands hold. `center` of mass and the inertia about it are in the "
     "object's "
     "frame; products are 0 unless given. A grasp names an operational point and where the "
     "object's frame is in it; the first three are not on one line. `shapes` is what `draw` and "
     "`--replay` show. The header of the code lists the internal forces.",
     "how-to/second-arm.md"},
    {"obstacles",
     "list of `name`, `sphere: {radius}` or `box: {size}`, `origin: {xyz, rpy}`, `avoid`", "none",
     "obstacles:\n"
     "  - {name: post, box: {size: [0.1, 0.1, 1.2]}, origin: {xyz: [0.5, 0.2, 0.6]}}",
     "What stands around a driven robot, at most 64; `avoid: false` where it may be touched. "
     "`drive` and `draw` show them. No generated code depends on them.",
     "reference/driving.md#obstacles"},
    {"ground", "`friction`, `restitution` (0 to 1), `step` (`true` or `false`)",
     "none; 0.8, 0 and false", "ground: {friction: 0.6, restitution: 0.3}",
     "The ground z < 0, on which `simulate` lets the robot fall, stand and slide, and `drive` lets "
     "it "
     "stand. With `step: true` the code has a step of time on it, NAME_ground.h.",
     "how-to/ground.md"},
    {"avoidance", "`reach`, `clearance` (m), `strength` (m⁴/s²), `points: [{link, xyz}]`",
     "0.15, 0.02, 5e-4; no points",
     "avoidance: {reach: 0.2, points: [{link: link3, xyz: [0, 0, 0.2]}]}",
     "How a driven robot keeps away from obstacles, with at most 32 points beside the "
     "operational "
     "ones.",
     "reference/driving.md#obstacles"},
    {"locked", "map from joint to coordinate, rad or m", "none", "locked: {joint5: 0.3, joint6: 0}",
     "Joints of one degree of freedom that are held at a value and have no coordinate.",
     "how-to/locked-joints.md"},
    {"armature",
     "`none`, `file`, or a map from joint to number or `{rotor_inertia, gear_ratio, gyroscopic, "
     "link, axis}`",
     "`none`", "armature: {joint1: 1.14}",
     "Inertia that a motor's rotor adds to its joint, kg m², or kg for joints that slide. `file` "
     "is "
     "rotor inertia times gear ratio squared, from `<drake:rotor_inertia>` with "
     "`<drake:gear_ratio>` or `<mechanicalReduction>` of a `<transmission>`, or from `<dynamics "
     "armature>`.",
     "how-to/friction.md"},
    {"joint_friction",
     "`none`, `viscous`, `coulomb`, or a map with `model`, `width`, `implicit`, `joints`",
     "`none`; a note if the URDF states some",
     "joint_friction: {model: coulomb, joints: {joint2: {damping: 0.5, friction: 0.2}}}",
     "Friction in the joints, from the file or stated here.", "how-to/friction.md"},
    {"joint_springs", "map from joint to `{stiffness, rest}`; `implicit`", "none",
     "joint_springs: {joint5: {stiffness: 40, rest: 0.3}}",
     "Springs in the joints, N m/rad and rad, or N/m and m; `rest` is 0 unless given.",
     "how-to/friction.md"},
    {"inputs",
     "`gravity`, `payload`, `parameters`, `base_parameters`, `tool`, `contact`, `active`, "
     "as a list or a map",
     "none", "inputs: {gravity: true, payload: {link: link6, mass: 3, reach: 0.3}}",
     "What of the robot functions take as arguments, because it changes while the robot runs.",
     "how-to/payload.md"},
    {"torque_limits", "`urdf`, or a map from joint to its motor's largest torque, N m or N", "none",
     "torque_limits: urdf",
     "With it, or with `friction` of a constraint, there is `NAME_limited.hpp`. It calls "
     "`mass_matrix`, `supported_control_torque`, `constraint_jacobian` and, for tasks, "
     "`jacobian`, "
     "which a list `functions` has to have.",
     "how-to/limits.md"},
    {"functions", "list of functions", "all defaults that the scene permits",
     "functions: [gravity, mass_matrix]",
     "The functions to generate; none, `[]`, for a controller alone.", "reference/functions.md"},
    {"regressor",
     "`parameters: all`, `base` or `none`; `links`, `payload`, `rotors`, `friction`, `width`",
     "all parameters of all links", "regressor: {parameters: base, rotors: true, friction: true}",
     "Which columns regressors have.", "explanation/parameters.md"},
    {"singular", "`smooth`, `early` or `exact`", "`smooth`", "singular: early",
     "What happens if a row of the task cannot be moved. `smooth`: the row is relaxed and every "
     "result stays finite. `early`: relaxed a little before, where joints would be thrown, as in "
     "the law of a `controller`. `exact`: the plain solve. Rows of `constraints` may depend on "
     "each other in any.",
     "explanation/singularities.md"},
    {"damped", "`{mass, inertia}`, kg and kg m²", "none", "damped: {mass: 40, inertia: 4}",
     "Adds `NAME_damped.hpp`, whose `damped_control_torque` relaxes directions of the task with "
     "a "
     "larger effective mass, as they occur near singularities. It calls `jacobian`, "
     "`bias_acceleration`, `inverse_dynamics` and `lambda_inverse`, which a list `functions` has "
     "to "
     "have. Not with priorities.",
     "how-to/singularities.md"},
    {"controller", "map with `laws` and settings", "none",
     "controller: {laws: [joint_impedance, task_impedance]}",
     "Adds `NAME_controller.h` with `NAME_step`: laws, limits, faults, safe torque.",
     "reference/controller.md"},
    {"batch", "2, 4, 8 or 16", "none", "batch: 8",
     "Adds `NAME_batch.hpp`: functions that take so many states in one call. They may be by "
     "another algorithm than those of one state; where rows of a task are relaxed, it is then in "
     "that algorithm's axes. With limits also `NAME_batch_limited.hpp`, in C "
     "`NAME_batch_limited.h`.",
     "how-to/batch.md"},
    {"language", "`c++` (C++17), `c` (C99) or `opencl` (OpenCL C 1.2)", "`c++`", "language: c",
     "Of the generated code. [OpenCL C](../how-to/opencl.md) has functions and kernels, no laws.",
     "how-to/c.md"},
    {"real", "`double` or `float`", "`double`", "real: float", "The number type of the code.",
     nullptr},
    {"target", "`generic` or a processor", "`generic`", "target: cortex-m7",
     "The processor that the code is for.", "reference/targets.md"},
    {"profile", "`plain` or `misra`", "`plain`", "profile: misra",
     "`misra`: code as rules for safe code ask.", "reference/safe-code.md"},
    {"optimize", "`speed` or `size`", "`speed`", "optimize: size",
     "`size`: functions loop over links where that is smaller, and the emitted `CMakeLists.txt` "
     "compiles for small code.",
     "explanation/small-code.md"},
    {"selftest", "1, 2, 4 or 8", "none", "selftest: 2",
     "Adds `NAME_selftest.h` with `NAME_selftest`, which calls each function in so many states and "
     "tells the first of which a result has other bits than on every other machine.",
     "how-to/own-board.md"},
    {"lanes", "1, 2, 4 or 8", "those of `target`, 8 for `generic`; 1 with `profile: misra`",
     "lanes: 1",
     "How many numbers the code may compute together with SIMD instructions. Compile with "
     "`-march` for the machine. 1 gives plain scalar code.",
     nullptr},
    {"sin_cos", "`computed` or `given`", "`computed`", "sin_cos: given",
     "`given`: functions take `sin_q` and `cos_q` after `q`. Rounding bounds then assume that "
     "each "
     "pair lies on the unit circle.",
     nullptr},
    {"accuracy", "`fastest`, `balanced` or `best`", "`balanced`", "accuracy: best",
     "How much accuracy to trade for speed. `fastest` adds constant offsets to the joint angles, "
     "which costs two digits at 1000 rad. `balanced` does so only for joints that stay within 8 "
     "rad. `best` never does, for five operations more per joint.",
     "explanation/rounding.md"},
    {"snap_angles", "rad, 0 to 1e-5", "0: angles as written", "snap_angles: 1e-5",
     "Treats angles within this tolerance of a multiple of pi/2 as exact. Only angles that look "
     "rounded are changed, such as 1.5708 or 3.14159265359, and each change is noted.",
     "evidence/generated-code.md#snapped-angles"},
    {"noise", "number, at most 1e-9, or `keep`", "4.4e-16, the spacing of doubles at pi",
     "noise: keep",
     "Treats what CAD programs leave as exact: angles in rad, and components of axes and offsets "
     "as "
     "a share of the robot's longest, that are this close to a quarter turn or to 0; of a centre "
     "of "
     "mass, 32 times this share of its distance from its joint where that is less. `keep` uses "
     "every number as written. `inspect --noise` lists the changes.",
     nullptr},
});

}  // namespace treeline
