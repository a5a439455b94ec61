#pragma once

#include "recursion/algebra/vector3.hpp"

namespace treeline {

/// Change of the rotational inertia about the origin of a body of this mass and first moment when
/// the origin moves by -p, by parallel axes: 2 (p.k) 1 - (p k^T + k p^T) with k = h + m p / 2.
template <class Scalar>
Symmetric3<Scalar> parallel_axes_shift(const Scalar& mass, const Vector3<Scalar>& h,
                                       const Vector3<Scalar>& p) {
  const Vector3<Scalar> k = h + p * (Scalar(0.5) * mass);
  const Scalar xx = p.x * k.x;
  const Scalar yy = p.y * k.y;
  const Scalar zz = p.z * k.z;
  const Scalar two(2.0);
  return {two * (yy + zz), -(p.x * k.y + p.y * k.x), -(p.x * k.z + p.z * k.x),
          two * (xx + zz), -(p.y * k.z + p.z * k.y), two * (xx + yy)};
}

}  // namespace treeline
