#pragma once

namespace treeline {

/// Motion that a step of a joint allows a link: turning about the z axis of its frame, sliding
/// along it, or moving freely with six degrees of freedom.
enum class JointKind { revolute, prismatic, floating };

/// Axis of a ball joint that a step is, if any. The three axes are always those of the ball joint's
/// own link, so that they stay at right angles in every pose.
enum class BallAxis { none, x, y, z };

/// The motion of a link relative to the link before it. Joints of several axes consist of several
/// steps with massless links between. `JointTypeInfo` says of which.
///
/// A ball joint turns by its quaternion in its first step. Its other steps do not move at all; they
/// only make the next axis of the same link the z axis. So the three velocities are those about the
/// link's own axes. All that is linear in velocities, accelerations or forces at an instant is that
/// of three hinges. The rates of the axes differ, because these turn with the last link: see
/// `continues_joint` and `outward_motion`.
struct JointStep {
  JointKind kind = JointKind::revolute;
  BallAxis ball = BallAxis::none;

  [[nodiscard]] constexpr bool is_floating() const { return kind == JointKind::floating; }
  [[nodiscard]] constexpr bool is_of_ball() const { return ball != BallAxis::none; }

  /// Entries of q that only this step has.
  [[nodiscard]] constexpr int coordinates() const {
    if (is_floating()) return 7;
    return ball == BallAxis::none ? 1 : ball == BallAxis::x ? 4 : 0;
  }
  /// Entries of qd.
  [[nodiscard]] constexpr int velocities() const { return is_floating() ? 6 : 1; }
  /// Position of a quaternion x y z w among its coordinates; -1: it has none.
  [[nodiscard]] constexpr int quaternion() const {
    return is_floating() ? 3 : ball == BallAxis::x ? 0 : -1;
  }

  /// Whether it has one coordinate, along or about a line that both links carry. Then its frame may
  /// be placed anywhere on that line, and turned about it.
  [[nodiscard]] constexpr bool has_one_coordinate() const {
    return !is_floating() && ball == BallAxis::none;
  }
  /// Whether it turns by an angle, to which constants may be added.
  [[nodiscard]] constexpr bool turns_by_angle() const {
    return kind == JointKind::revolute && ball == BallAxis::none;
  }
  /// Whether the axes of its frame turn relative to those of the link before.
  [[nodiscard]] constexpr bool turns_axes() const {
    return kind != JointKind::prismatic && !continues_joint();
  }
  /// Whether it is a further axis of the joint that the step before began.
  [[nodiscard]] constexpr bool continues_joint() const {
    return ball == BallAxis::y || ball == BallAxis::z;
  }
  /// Whether another axis of the same joint follows.
  [[nodiscard]] constexpr bool is_continued() const {
    return ball == BallAxis::x || ball == BallAxis::y;
  }

  /// Whether degree of freedom `k` is a rotation. The translations come first.
  [[nodiscard]] constexpr bool is_angular(int k) const {
    return kind == JointKind::revolute || k >= 3;
  }
  /// Index of the axis of the link's frame about or along which degree of freedom `k` is: 0 for x.
  [[nodiscard]] constexpr int axis(int k) const { return is_floating() ? k % 3 : 2; }
};

/// Selects the entry of a linear or angular vector that belongs to the axis of a joint with one
/// degree of freedom.
template <class Vector>
auto& along_axis(JointKind kind, Vector& linear, Vector& angular) {
  return kind == JointKind::revolute ? angular.z : linear.z;
}

}  // namespace treeline
