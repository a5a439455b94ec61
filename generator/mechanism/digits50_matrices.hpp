#pragma once

#include <Eigen/Core>

#include "digits/digits50.hpp"

namespace treeline {

/// The constants of a mechanism are computed with 50 decimal digits and rounded once, on entry into
/// an expression graph. So reductions add no rounding error and leave no residue (what cancels ends
/// below 1e-40 and becomes zero, see `resolved`), and the bytes are the same on every host.
using Digits50Vector3 = Eigen::Matrix<Digits50, 3, 1>;
using Digits50Matrix3 = Eigen::Matrix<Digits50, 3, 3>;

/// Pose of a child frame in its parent: x_parent = R x_child + p.
struct Digits50Pose {
  Digits50Matrix3 R = Digits50Matrix3::Identity();
  Digits50Vector3 p = Digits50Vector3::Zero();
};

inline Digits50Pose operator*(const Digits50Pose& a, const Digits50Pose& b) {
  return {a.R * b.R, a.R * b.p + a.p};
}
inline Digits50Pose inverse(const Digits50Pose& a) {
  const Digits50Matrix3 Rt = a.R.transpose();
  return {Rt, -(Rt * a.p)};
}

/// Returns `value`, or zero if it is the residue of an exact cancellation of quantities of size
/// `scale`.
inline Digits50 snapped(const Digits50& value, const Digits50& scale) {
  static const Digits50 kResidue("1e-30");
  return abs(value) <= kResidue * scale ? Digits50(0) : value;
}

/// Rotation by `angle` (rad) about z.
Digits50Matrix3 rotation_z(const Digits50& angle);

}  // namespace treeline
