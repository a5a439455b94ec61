#pragma once

#include "interpreter/model.hpp"

namespace treeline::interpreter {

/// Number of velocities of a joint of this kind that are translations. They come first; the others
/// are rotations.
constexpr int translation_count(JointKind kind) {
  constexpr std::array kCounts{0, 0, 1, 2, 3, 0};
  return kCounts[static_cast<std::size_t>(kind)];
}

/// Whether a joint of this kind has a quaternion x y z w: its last four coordinates.
constexpr bool has_quaternion(JointKind kind) {
  return kind == JointKind::floating || kind == JointKind::spherical;
}

/// First entry in q of the quaternion of a body's joint; -1: it has none.
template <class Scalar>
int quaternion_of(const Body<Scalar>& body) {
  return has_quaternion(body.kind) ? body.q + position_count(body.kind) - 4 : -1;
}

}  // namespace treeline::interpreter
