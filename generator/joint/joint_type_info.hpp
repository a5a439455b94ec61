#pragma once

#include <cstddef>
#include <span>

#include "joint/coordinate_kind.hpp"
#include "joint/joint_step.hpp"

namespace treeline {

/// Joint types of files. `ball` is an extension of URDF, as iDynTree, PyBullet and Drake read it.
enum class JointType { revolute, continuous, prismatic, fixed, floating, planar, ball };
inline constexpr std::size_t kJointTypeCount = 7;

/// An entry of q of a joint, as the contract of the emitted code lists it.
struct JointCoordinate {
  const char* meaning;  ///< with unit: "angle, rad"
  CoordinateKind kind;
};

/// Axis that a step makes the z axis of its frame. z is the joint's axis, or for joints without
/// one the z axis of the joint's frame.
enum class StepAxis { x, y, z };

/// A step of a joint, see `JointStep`. The frame of every step has the origin and, but for the
/// order of its axes, the directions of the joint's frame moved by the steps before.
struct JointTypeStep {
  JointStep motion;
  StepAxis axis;
  /// Appended to the name of the joint's link. The last step carries the link itself, with none.
  const char* suffix;
};

/// All that is known of a joint type but for the mathematics of its steps.
struct JointTypeInfo {
  JointType type;
  const char* name;                  ///< in files
  const char* other_name = nullptr;  ///< that files may use too
  bool is_standard = true;           ///< whether URDF itself defines it
  bool has_axis = true;              ///< whether <axis> means something
  bool has_range = false;            ///< whether <limit> gives a range of positions
  std::span<const JointCoordinate> coordinates;
  /// Text after the joint's name for each velocity: ", rad/s".
  std::span<const char* const> velocities;
  std::span<const JointTypeStep> steps;
  /// Text of the emitted contract about q, qd and tau; empty where the meanings of the coordinates
  /// suffice.
  const char* convention = "";

  [[nodiscard]] constexpr int positions() const { return static_cast<int>(coordinates.size()); }
  [[nodiscard]] constexpr int freedoms() const { return static_cast<int>(velocities.size()); }
  [[nodiscard]] constexpr bool moves() const { return !velocities.empty(); }
  /// Whether it can mimic, be mimicked and be locked at a value.
  [[nodiscard]] constexpr bool has_one_freedom() const { return velocities.size() == 1; }
  /// Whether its one coordinate is a length, m, and not an angle, rad.
  [[nodiscard]] constexpr bool slides() const {
    return has_one_freedom() && coordinates.front().kind == CoordinateKind::displacement;
  }
};

}  // namespace treeline
