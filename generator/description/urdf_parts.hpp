#pragma once

#include <tinyxml2.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "description/limit.hpp"
#include "description/robot.hpp"
#include "description/urdf_element.hpp"
#include "joint/joint_type.hpp"

namespace treeline {

/// A joint as the file has it: links and the mimicked joint are still names.
struct NamedJoint {
  Joint joint;
  std::string parent, child;
  std::optional<std::string> mimicked;  ///< set together with `joint.mimic`
  UrdfElement element;                  ///< for complaints about it
};

/// Reads `<joint>`. Axes are normalised; bounds that the file does not set are infinite, except
/// that a lone `lower` or `upper` has the other at 0, as the URDF specification says. A mimic on a
/// fixed or floating joint is dropped with a warning.
NamedJoint read_joint(const UrdfElement& element);

/// Reads `<axis xyz>` of a joint, or a child of another name, as a unit vector in the joint's
/// frame; x where there is none.
std::array<double, 3> read_axis(const UrdfElement& joint, const char* name = "axis");

/// The limits of a joint, from its `<limit>`; nothing where there is none. What exporters write for
/// a limit that nobody has filled in is implausible: an effort or a speed of 0, below 0 or beyond
/// what anything reaches, a range whose ends are the same, exchanged or out of reach.
/// `warn_of_limits` names these once. A limit that the file lacks is told here.
std::optional<Limits> read_joint_limits(const UrdfElement& joint, JointType type);

/// Reads `<link>`: its name and its first `<inertial>`. Shapes and materials do not matter.
Link read_link(const UrdfElement& element);

/// The reciprocal of a smaller mass may leave the range of double.
inline constexpr double kSmallestMass = 1e-100;    ///< kg
inline constexpr double kSmallestMoment = 1e-100;  ///< kg m^2

/// The mass that a link with this one has: 0 where it is too small to compute with.
double counted_mass(double mass);

/// Makes the moments 0 if all are too small to compute with. Returns the largest that was lost, 0
/// if none was.
double drop_smallest_moments(Inertial& inertial);

/// Whether the element is a joint that closes a loop, as Drake and Isaac Sim write it: `<loop_joint
/// name type><axis xyz/><link1 link xyz rpy/><link2 link xyz rpy/></loop_joint>`, where the type is
/// `spherical`, `fixed`, or about or along the axis, which has the same components in both frames,
/// `revolute`, `continuous`, `prismatic`.
bool is_loop_joint(const UrdfElement& element);

/// Reads it. An error for another type, for a link that the robot does not have, and for a name
/// that is taken.
void read_loop_joint(const UrdfElement& element, Robot& robot);

/// Whether the element is a `<constraint>` as it is proposed for URDF (urdfdom, pull request 264):
/// `<constraint name type><parent link/><parent_origin xyz rpy/><parent_axis xyz/>`, and likewise
/// of the child.
bool is_constraint(const UrdfElement& element);

/// Reads it as a loop that a scene can close, of the types of a `<loop_joint>`. With a note.
void read_constraint_hint(const UrdfElement& element, Robot& robot);

/// Finds pairs of links `closing_NAME_1` and `closing_NAME_2`, as onshape-to-robot leaves them
/// where it opens a loop: points that a scene can hold together. With a note.
void find_closing_frames(Robot& robot, UrdfReading& reading);

/// Reads the rotors of motors from the robot's `<transmission>` elements into `Joint::rotor`: the
/// gear ratio from `<drake:gear_ratio value>` or the text of `<mechanicalReduction>`, the inertia
/// (kg m^2 about the motor's axis) from `<drake:rotor_inertia value>`,
/// `<rotorInertia>` or `<motorInertia>`. A `<transmission>` of
/// several joints or motors couples them and is passed over, with a warning where it has an
/// inertia.
void read_rotors(const UrdfElement& robot, std::vector<Joint>& joints);

/// Kinetic energy of the rotor is armature qd^2 / 2: inertia times the square of the gear ratio,
/// kg m^2 (kg for a sliding joint). 0 where the file states no inertia.
double armature_of(const Joint& joint);

/// Gives every joint the indices of its links and the robot its joints and root, and reports what
/// keeps them from being one tree: a link that no element defines, two parents, a loop, several
/// roots. `elements` are those of the robot's links.
void connect_tree(std::vector<NamedJoint>& joints, const std::vector<UrdfElement>& elements,
                  Robot& robot, UrdfReading& reading);

/// Adds the link `world` where a joint has it for its parent and no link has this name, as files do
/// for programs that know a world: it is what holds the base. With a note.
void declare_world(tinyxml2::XMLElement& robot, UrdfReading& reading);

/// Narrows the limits of position and speed of each joint that others follow, so that these stay
/// within theirs: q = multiplier q_leader + offset. Warns where a follower permits less than its
/// leader's own limits, and leaves out a range that has no position in common with them. A
/// follower's effort limits no motor, for it has none.
void fold_follower_limits(const std::vector<NamedJoint>& joints, Robot& robot);

/// Gives each mimic joint of the robot the joint that it follows in the end, with the multipliers
/// and offsets of a chain of mimics put together. False, with errors, when a name is unknown, the
/// chain closes on itself, or the joint followed has not one degree of freedom.
bool resolve_mimics(const std::vector<NamedJoint>& joints, Robot& robot);

/// Warns of what stands inside the elements of visuals, collisions and materials that hold
/// attributes alone, such as `<color>`: nothing reads it. The same of shapes behind the first one
/// in a `<geometry>`.
void check_looks(const UrdfElement& robot);

/// Indices of the joints whose coordinate moves no mass and no inertia: neither the joint nor one
/// that mimics it has any beyond it. Their rows of the mass matrix are zero.
std::vector<int> find_massless_joints(const Robot& robot);

/// Whether any link of the robot has mass or a moment of inertia.
bool moves_inertia(const Robot& robot);

/// Warns of a world with inertia, and of links that have a shape but no inertial.
void check_motion(const Robot& robot, const std::vector<UrdfElement>& elements,
                  UrdfReading& reading);

}  // namespace treeline
