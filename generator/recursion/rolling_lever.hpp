#pragma once

#include "recursion/tree.hpp"

// Graphs have no square root. None is needed: while the contact is held, the distance of two balls
// is the sum of their radii, and the height of a disc's centre is the radius times the sine of its
// lean.

namespace treeline {

/// Where a contact that rolls is, along the axes of the second frame.
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

/// A disc on a plane with the normal z. The contact is the lowest point of its rim, below the
/// centre by d.z: r = -radius^2 (z - (z . a) a) / d.z, a: axis.
template <class Scalar>
RollingLever<Scalar> lever_of_disc(const Scalar& radius, const Vector3<Scalar>& d,
                                   const Vector3<Scalar>& a, const Vector3<Scalar>& v,
                                   const Vector3<Scalar>& w) {
  const Scalar squared = radius * radius;
  const Scalar inverse = Scalar(1.0) / d.z;
  const Vector3<Scalar> turned = cross(w, a);
  const Vector3<Scalar> down{a.z * a.x, a.z * a.y, a.z * a.z - Scalar(1.0)};
  const Vector3<Scalar> r = down * (squared * inverse);
  const Vector3<Scalar> moved = a * turned.z + turned * a.z;
  const Scalar gap = (d.z - squared * (Scalar(1.0) - a.z * a.z) * inverse) * Scalar(0.5);
  return {r, moved * (squared * inverse) - r * (v.z * inverse), {Scalar(0.0), Scalar(0.0), gap}};
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
