#pragma once

#include <Eigen/Core>

#include "digits/digits50.hpp"

namespace treeline {

/// The constants of a mechanism are computed with 50 decimal digits and rounded once, on entry into
/// an expression graph. So reductions add no rounding error and leave no residue (what cancels ends
/// below 1e-40 and becomes zero, see `resolved`), and the bytes are the same on every host.
using Exact = Digits50;
using ExactVector3 = Eigen::Matrix<Exact, 3, 1>;
using ExactMatrix3 = Eigen::Matrix<Exact, 3, 3>;

/// Pose of a child frame in its parent: x_parent = R x_child + p.
struct ExactPose {
  ExactMatrix3 R = ExactMatrix3::Identity();
  ExactVector3 p = ExactVector3::Zero();
};

inline ExactPose operator*(const ExactPose& a, const ExactPose& b) {
  return {a.R * b.R, a.R * b.p + a.p};
}
inline ExactPose inverse(const ExactPose& a) {
  const ExactMatrix3 Rt = a.R.transpose();
  return {Rt, -(Rt * a.p)};
}

/// Returns `value`, or zero if it is the residue of an exact cancellation of quantities of size
/// `scale`.
inline Exact snapped(const Exact& value, const Exact& scale) {
  static const Exact kResidue("1e-30");
  return abs(value) <= kResidue * scale ? Exact(0) : value;
}

/// Rotation by `angle` (rad) about z.
ExactMatrix3 rotation_z(const Exact& angle);

}  // namespace treeline
