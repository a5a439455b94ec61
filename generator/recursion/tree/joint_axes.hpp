#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "recursion/tree/tree.hpp"

namespace treeline {

/// One degree of freedom of a joint, in the axes of the link behind it. A displacement of a
/// floating or ball joint is a twist of the link in its own axes, linear over angular.
template <class Scalar>
struct JointAxis {
  std::size_t column = 0;  ///< velocity of the axis
  Scalar multiplier{};
  Vector3<Scalar> slide, turn;  ///< unit vector along or about which it moves; one of them is zero
  bool turns = false;
};

/// Degrees of freedom of a link's joint. The last link of a ball joint has all three, the other
/// links none: the joint's axes move with the last.
template <class Scalar>
std::vector<JointAxis<Scalar>> joint_axes(const TreeLink<Scalar>& link) {
  if (link.is_continued()) return {};
  const Scalar zero(0.0);
  const Scalar one(1.0);
  const std::array<Vector3<Scalar>, 3> units{
      {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
  const int count = link.is_of_ball() ? 3 : link.velocities();
  const auto at = static_cast<std::size_t>(link.v_index + link.velocities() - count);
  std::vector<JointAxis<Scalar>> axes;
  for (int k = 0; k < count; ++k) {
    JointAxis<Scalar> axis;
    axis.column = at + static_cast<std::size_t>(k);
    axis.multiplier = link.is_floating() ? one : link.multiplier;
    axis.turns = link.is_angular(k);
    (axis.turns ? axis.turn : axis.slide) =
        units[static_cast<std::size_t>(link.is_of_ball() ? k : link.axis(k))];
    axes.push_back(axis);
  }
  return axes;
}

/// Degree of freedom `k` of the link's joint as linear and angular unit velocity, in its axes.
template <class Scalar>
struct UnitMotion {
  Vector3<Scalar> v, w;
};
template <class Scalar>
UnitMotion<Scalar> unit_motion(const TreeLink<Scalar>& link, int k) {
  const Scalar zero(0.0);
  const Scalar one(1.0);
  const Vector3<Scalar> none{zero, zero, zero};
  const Vector3<Scalar> axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  const Vector3<Scalar>& e = axes[link.axis(k)];
  return link.is_angular(k) ? UnitMotion<Scalar>{none, e} : UnitMotion<Scalar>{e, none};
}

}  // namespace treeline
