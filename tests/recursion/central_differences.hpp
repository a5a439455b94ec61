#pragma once

#include <Eigen/Geometry>

#include "interpreter/instances.hpp"
#include "interpreter/joint_parts.hpp"

/// Derivatives by central differences in 50 digits, which share nothing with rules of
/// differentiation.
namespace treeline::tests {

using interpreter::Digits50;
using Matrix50 = interpreter::Matrix<Digits50>;
using Vector50 = interpreter::Vector<Digits50>;

/// q displaced along `d`: floating joints by p + R d_v with the quaternion rotated by d_w in the
/// child's axes, ball joints by such a rotation, other joints by addition. Exact, without a series.
inline Vector50 displaced(const interpreter::Model<Digits50>& model, const Vector50& q,
                          const Vector50& d) {
  Vector50 moved = q;
  for (const auto& body : model.bodies) {
    if (body.mimics) continue;
    const int n = interpreter::velocity_count(body.kind);
    const int first = interpreter::quaternion_of(body);
    if (first < 0) {
      moved.segment(body.q, n) += d.segment(body.v, n);
      continue;
    }
    const Eigen::Quaternion<Digits50> turn(q(first + 3), q(first), q(first + 1), q(first + 2));
    const interpreter::Vector3<Digits50> w = d.segment<3>(body.v + n - 3);
    const Digits50 angle = sqrt(w.squaredNorm());
    const Digits50 s = angle == 0 ? Digits50(0) : Digits50(sin(angle / 2) / angle);
    const Eigen::Quaternion<Digits50> turned =
        turn * Eigen::Quaternion<Digits50>(cos(angle / 2), s * w(0), s * w(1), s * w(2));
    if (body.kind == interpreter::JointKind::floating) {
      moved.segment<3>(body.q) += turn.toRotationMatrix() * d.segment<3>(body.v);
    }
    moved.segment<4>(first) = turned.coeffs();
  }
  return moved;
}

/// Columns (f(h e_j) - f(-h e_j)) / 2h, with an error of h^2 = 1e-36 and of 1e-50 / h by
/// cancellation.
template <class Function>
Matrix50 differences(Eigen::Index n, Function f) {
  const Digits50 h("1e-18");
  Matrix50 result(f(Vector50(Vector50::Zero(n))).size(), n);
  for (Eigen::Index j = 0; j < n; ++j) {
    Vector50 step = Vector50::Zero(n);
    step(j) = h;
    result.col(j) = (f(step) - f(Vector50(-step))) / (2 * h);
  }
  return result;
}

/// Tolerance of a difference, relative to the largest entry. A solve multiplies it by the condition
/// number.
constexpr double kDifferenceBound = 1e-28;

}  // namespace treeline::tests
