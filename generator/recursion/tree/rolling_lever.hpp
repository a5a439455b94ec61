#pragma once

#include "recursion/tree/tree.hpp"

// Graphs have no square root. None is needed: while the contact is held, the distance of two balls
// is the sum of their radii, and a disc's line of steepest descent ends at the plane.

namespace treeline {

/// Position of a rolling contact, along the axes of the second frame.
template <class Scalar>
struct RollingLever {
  Vector3<Scalar> r;      ///< from the first frame's origin to the contact
  Vector3<Scalar> rate;   ///< of r
  Vector3<Scalar> error;  ///< gap along the normal
};

/// Two balls in contact: the normal is d / (radius + on_radius).
template <class Scalar>
RollingLever<Scalar> lever_on_ball(const TreeRolling<Scalar>& rolling, const Vector3<Scalar>& d,
                                   const Vector3<Scalar>& v) {
  const Scalar distance = rolling.radius + *rolling.on_radius;
  const Scalar share = -rolling.radius / distance;
  const Scalar gap = (dot(d, d) / (distance * distance) - Scalar(1.0)) * Scalar(0.5);
  return {d * share, v * share, d * gap};
}

/// A disc on a plane with the normal z. The contact is where the line of steepest descent from its
/// centre meets the plane: r = -d.z (z - (z . a) a) / s^2, a: axis, s: sine of the angle between z
/// and a. A disc that lies flat, s = 0, has no such line. The error is (d.z^2 - (s radius)^2) / 2
/// radius, s times the gap.
template <class Scalar>
RollingLever<Scalar> lever_of_disc(const Scalar& radius, const Vector3<Scalar>& d,
                                   const Vector3<Scalar>& a, const Vector3<Scalar>& v,
                                   const Vector3<Scalar>& w) {
  const Scalar squared = a.x * a.x + a.y * a.y;  // s^2
  const Scalar inverse = Scalar(1.0) / squared;
  const Scalar share = d.z * inverse;
  const Vector3<Scalar> down{a.z * a.x, a.z * a.y, -squared};
  const Vector3<Scalar> turned = cross(w, a);
  const Vector3<Scalar> moved = a * turned.z + turned * a.z;  // rate of `down`
  const Scalar share_rate = (v.z + share * moved.z) * inverse;
  const Scalar gap = (d.z * d.z - squared * (radius * radius)) * (Scalar(0.5) / radius);
  return {down * share, moved * share + down * share_rate, {Scalar(0.0), Scalar(0.0), gap}};
}

/// `d`: from the second origin to the first; `a`: axis of a disc; `v`, `w`: velocities of the first
/// frame seen from the second. All along the axes of the second frame.
template <class Scalar>
RollingLever<Scalar> rolling_lever(const TreeRolling<Scalar>& rolling, const Vector3<Scalar>& d,
                                   const Vector3<Scalar>& a, const Vector3<Scalar>& v,
                                   const Vector3<Scalar>& w) {
  if (rolling.on_radius) return lever_on_ball(rolling, d, v);
  if (rolling.axis) return lever_of_disc(rolling.radius, d, a, v, w);
  const Scalar zero(0.0);
  return {{zero, zero, -rolling.radius}, {zero, zero, zero}, {zero, zero, d.z - rolling.radius}};
}

}  // namespace treeline
