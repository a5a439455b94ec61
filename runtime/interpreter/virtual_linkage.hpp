#pragma once

#include <Eigen/LU>

#include "interpreter/closed_chain.hpp"

namespace treeline::interpreter {

/// Number of internal forces of an object held by this many grasps. The virtual linkage of the
/// grasps (Williams & Khatib 1993) describes forces of the hands that do not move the object, by 6
/// (N - 1) numbers for N grasps. Its links are virtual rods between grasp points. Their tension is
/// positive if it would stretch the object, so it is negative in a squeeze.
///   N = 1: none.
///   N = 2: the linkage's frame has x from grasp 1 to grasp 2, y = up x x, z = x x y. Here up is
///   the
///     object's z axis, or its x axis if x is within about 26 degrees of z (|x_z| > 0.9).
///     [tension; torsion (m_2 - m_1).x / 2; m_1.y; m_1.z; m_2.y; m_2.z], m_i the moment of grasp i.
///   N >= 3: the tensions of the rods 12, 23, 31, then for each further grasp k of 1k, 2k, 3k; then
///     the moments m_1 .. m_N, three each in the object's axes. Grasps 1, 2, 3 must not lie on a
///     line, nor a further one in their plane.
/// Forces of grasps act ON the object at the grasp's point.
constexpr int internal_force_count(int grasps) {
  return 6 * (grasps - 1);
}

namespace detail {

/// The grasp's point in the object's frame.
template <class Scalar>
Vector3<Scalar> point_on_object(const Grasp<Scalar>& grasp) {
  return -(grasp.R.transpose() * grasp.p);
}

/// Axes x, y, z of the linkage's frame in the object's axes as columns, from the unit vector x.
template <class Scalar>
Matrix3<Scalar> linkage_frame(const Vector3<Scalar>& x) {
  using std::abs;
  using std::sqrt;
  const bool along_z = abs(x(2)) > Scalar(9) / Scalar(10);
  const Vector3<Scalar> up = along_z ? Vector3<Scalar>::UnitX() : Vector3<Scalar>::UnitZ();
  Vector3<Scalar> y = cross(up, x);
  y /= Scalar(sqrt(y.squaredNorm()));
  Matrix3<Scalar> frame;
  frame << x, y, cross(x, y);
  return frame;
}

template <class Scalar>
Vector3<Scalar> unit_between(const Vector3<Scalar>& from, const Vector3<Scalar>& to) {
  using std::sqrt;
  const Vector3<Scalar> step = to - from;
  return step / Scalar(sqrt(step.squaredNorm()));
}

/// E: forces on the object at the grasps' points per unit tension of the rods, 3 N x 3 (N - 2).
template <class Scalar>
Matrix<Scalar> rod_forces(const std::vector<Vector3<Scalar>>& r) {
  const int n = static_cast<int>(r.size());
  Matrix<Scalar> E = Matrix<Scalar>::Zero(3 * n, 3 * (n - 2));
  int rod = 0;
  const auto add = [&](int i, int j) {
    const Vector3<Scalar> e =
        unit_between(r[static_cast<std::size_t>(i)], r[static_cast<std::size_t>(j)]);
    E.template block<3, 1>(3 * i, rod) = -e;
    E.template block<3, 1>(3 * j, rod) = e;
    ++rod;
  };
  add(0, 1);
  add(1, 2);
  add(2, 0);
  for (int k = 3; k < n; ++k) {
    for (int base = 0; base < 3; ++base) add(base, k);
  }
  return E;
}

/// The rows of W that give the internal forces from the grasps' forces.
template <class Scalar>
Matrix<Scalar> internal_rows(const std::vector<Vector3<Scalar>>& r) {
  const int n = static_cast<int>(r.size());
  Matrix<Scalar> rows = Matrix<Scalar>::Zero(internal_force_count(n), 6 * n);
  if (n == 2) {
    const Matrix3<Scalar> frame = linkage_frame(unit_between(r[0], r[1]));
    const auto x = frame.col(0).transpose();
    rows.template block<1, 3>(0, 0) = -x / Scalar(2);
    rows.template block<1, 3>(0, 6) = x / Scalar(2);
    rows.template block<1, 3>(1, 3) = -x / Scalar(2);
    rows.template block<1, 3>(1, 9) = x / Scalar(2);
    rows.template block<2, 3>(2, 3) = frame.template rightCols<2>().transpose();
    rows.template block<2, 3>(4, 9) = frame.template rightCols<2>().transpose();
  } else if (n > 2) {
    const Matrix<Scalar> E = rod_forces(r);
    const Matrix<Scalar> left_inverse =
        Matrix<Scalar>(E.transpose() * E).ldlt().solve(Matrix<Scalar>(E.transpose()));
    for (int i = 0; i < n; ++i) {
      rows.block(0, 6 * i, 3 * (n - 2), 3) = left_inverse.middleCols(3 * i, 3);
      rows.template block<3, 3>(3 * (n - 2) + 3 * i, 6 * i + 3).setIdentity();
    }
  }
  return rows;
}

}  // namespace detail

/// W, the grasp description matrix, 6 N x 6 N: [resultant; internal] = W [f_1; m_1; ... f_N; m_N].
/// Everything is in the object's axes: the resultant is at the object's origin, f_i and m_i of
/// grasp i act on the object at the grasp's point. For N >= 3 the tensions are E^+ f, the
/// least-squares solution.
template <class Scalar>
Matrix<Scalar> grasp_description(const GraspedObject<Scalar>& object) {
  std::vector<Vector3<Scalar>> r;
  for (const auto& grasp : object.grasps) r.push_back(detail::point_on_object(grasp));
  const int n = static_cast<int>(r.size());
  Matrix<Scalar> W = Matrix<Scalar>::Zero(6 * n, 6 * n);
  for (int i = 0; i < n; ++i) {
    W.template block<6, 6>(0, 6 * i) =
        force_transform<Scalar>(Matrix3<Scalar>::Identity(), r[static_cast<std::size_t>(i)]);
  }
  W.bottomRows(internal_force_count(n)) = detail::internal_rows(r);
  return W;
}

/// The forces of all grasps with this resultant and these internal forces.
template <class Scalar>
Vector<Scalar> split_over_grasps(const GraspedObject<Scalar>& object,
                                 const Vector6<Scalar>& resultant, VectorArg<Scalar> internal) {
  Vector<Scalar> wanted(6 + internal.size());
  wanted << resultant, internal;
  return grasp_description(object).fullPivLu().solve(wanted);
}

/// Number of internal forces of all objects together.
template <class Scalar>
int internal_force_count(const ClosedChain<Scalar>& chain) {
  int count = 0;
  for (const auto& object : chain.objects) {
    count += internal_force_count(static_cast<int>(object.grasps.size()));
  }
  return count;
}

}  // namespace treeline::interpreter
