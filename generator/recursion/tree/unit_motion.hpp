#pragma once

#include "recursion/tree/tree.hpp"

namespace treeline {

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
