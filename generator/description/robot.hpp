#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/limit.hpp"
#include "joint/joint_type.hpp"

namespace treeline {

/// Position in metres and fixed-axis roll, pitch, yaw in radians, of a child frame in its parent,
/// exactly as the file has them: R = Rz(yaw) Ry(pitch) Rx(roll).
struct Pose {
  std::array<double, 3> xyz{};
  std::array<double, 3> rpy{};
  int line = 0;  ///< of the element in the file
};

/// Mass in kg; `origin` is the frame at the centre of mass, in the link's frame; the inertia in
/// kg m^2 is about the centre of mass, in the axes of `origin`.
struct Inertial {
  double mass = 0;
  Pose origin;
  double ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0;
};

struct Link {
  std::string name;
  std::optional<Inertial> inertial;  ///< absent: the file gives none, the link is massless
  int line = 0;                      ///< of the element in the file
};

/// q = multiplier * q[joint] + offset. Chains of mimics are put together.
struct Mimic {
  int joint = -1;  ///< index into Robot::joints of a joint that is no mimic itself
  double multiplier = 1;
  double offset = 0;
};

/// The rotor of a motor that drives a joint through a gear, as the file states it.
struct Rotor {
  std::optional<double> inertia;  ///< about the motor's axis, kg m^2
  double ratio = 1;               ///< turns of the motor for one of the joint
};

struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  int parent = -1;  ///< index into Robot::links
  int child = -1;   ///< index into Robot::links
  Pose origin;      ///< joint frame (= child link frame at q = 0) in parent
  /// Unit vector in the joint frame; planar: the normal. Without meaning for types without an axis.
  std::array<double, 3> axis{1, 0, 0};
  int axis_line = 0;
  /// Limits, with those of joints that follow it, see `fold_follower_limits`. Absent: none in file.
  std::optional<Limits> limits;
  std::optional<Mimic> mimic;
  double damping = 0, friction = 0;
  std::optional<Rotor> rotor;
  /// The child is a rotor, symmetric about the axis: how far it has turned does not matter.
  bool spins = false;
  int line = 0;
};

/// A joint that closes a loop, beside the tree: `rows` of the relative motion of two frames are
/// held, along the axes of the second.
struct RobotLoop {
  struct End {
    std::string link;
    Pose origin;
  };
  std::string name;
  End first, second;
  std::array<bool, 6> rows{true, true, true, true, true, true};  ///< x y z rx ry rz
};

/// N m/rad and rad, or N/m and m.
struct SpringHint {
  double stiffness = 0, rest = 0;
};

/// A loop that the file describes beside URDF, and how.
struct LoopHint {
  RobotLoop loop;
  std::string reason;
};

/// What a file says that a scene decides: `init-scene` proposes it.
struct SceneHints {
  bool floats = false;                           ///< nothing holds the root link to the world
  std::optional<std::array<double, 3>> gravity;  ///< m/s^2
  std::map<std::string, SpringHint> springs;     ///< by joint
  std::vector<LoopHint> loops;
};

/// One of the robots that a scene joins at the world, see `join_robots`.
struct RobotPart {
  std::string name;  ///< an identifier; names of its links and joints begin with it and a slash
  std::string file;  ///< path it was read from, for diagnostics
};

/// Content of a URDF, checked: names are unique, the joints make the links one tree, axes have unit
/// length, no mass is negative, mimic joints lead to a joint that is not one. Links and joints are
/// in the file's order. `read_urdf` makes it, and `join_robots` of several.
struct Robot {
  std::string name;
  std::string file;  ///< path it was read from, for diagnostics
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<RobotLoop> loops;
  int root = -1;  ///< index of the root link
  SceneHints hints;
  std::vector<RobotPart> parts;  ///< of several robots in one scene; empty: one robot
};

}  // namespace treeline
