#pragma once

#include <Eigen/LU>
#include <utility>
#include <vector>

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
///     line. Where k lies in their plane (unit vectors from it to them span a volume of less than
///     0.01), it has the tensions of two rods and a warp. The rods lead to the two of 1, 2, 3 that
///     k sees nearest to a right angle, in the order 12, 23, 31 of these pairs; the square of a
///     later pair's sine must be larger by 0.001. The warp is a force at k along the normal (r_2 -
///     r_1) x (r_3 - r_1), which 1, 2, 3 balance by forces along it.
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

/// Corners 0, 1, 2 of the first triangle that a point at `p` pulls by its rods: all of them, or two
/// where it lies in their plane.
template <class Scalar>
std::vector<int> pulled_corners(const std::vector<Vector3<Scalar>>& r, const Vector3<Scalar>& p) {
  using std::abs;
  Matrix3<Scalar> to;
  for (int i = 0; i < 3; ++i) to.col(i) = unit_between(p, r[static_cast<std::size_t>(i)]);
  if (abs(Scalar(to.determinant())) >= Scalar(1) / Scalar(100)) return {0, 1, 2};
  std::vector<int> corners;
  Scalar best = -1;
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
    const Scalar cosine = to.col(i).dot(to.col(j));
    const Scalar sine_squared = Scalar(1) - cosine * cosine;
    if (sine_squared <= best + Scalar(1) / Scalar(1000)) continue;
    best = sine_squared;
    corners = {i, j};
  }
  return corners;
}

/// Forces at the grasps' points of the unit warp of grasp k. Those of 1, 2, 3 are in the shares a
/// of r_k = r_1 + a_2 (r_2 - r_1) + a_3 (r_3 - r_1), but for what of r_k is along the normal.
template <class Scalar>
Vector<Scalar> warp_forces(const std::vector<Vector3<Scalar>>& r, int k) {
  using std::sqrt;
  Eigen::Matrix<Scalar, 3, 2> edges;
  edges << r[1] - r[0], r[2] - r[0];
  Vector3<Scalar> normal = cross<Scalar>(edges.col(0), edges.col(1));
  normal /= Scalar(sqrt(normal.squaredNorm()));
  const Vector3<Scalar> arm = r[static_cast<std::size_t>(k)] - r[0];
  const Eigen::Matrix<Scalar, 2, 2> gram = edges.transpose() * edges;
  const Eigen::Matrix<Scalar, 2, 1> along = edges.transpose() * arm;
  const Eigen::Matrix<Scalar, 2, 1> a = gram.fullPivLu().solve(along);
  Vector<Scalar> forces = Vector<Scalar>::Zero(3 * static_cast<Eigen::Index>(r.size()));
  forces.template segment<3>(0) = -(Scalar(1) - a(0) - a(1)) * normal;
  forces.template segment<3>(3) = -a(0) * normal;
  forces.template segment<3>(6) = -a(1) * normal;
  forces.template segment<3>(3 * k) = normal;
  return forces;
}

/// E: forces on the object at the grasps' points per unit tension of the rods and per unit warp,
/// 3 N x 3 (N - 2).
template <class Scalar>
Matrix<Scalar> linkage_forces(const std::vector<Vector3<Scalar>>& r) {
  const int n = static_cast<int>(r.size());
  Matrix<Scalar> E = Matrix<Scalar>::Zero(3 * n, 3 * (n - 2));
  int column = 0;
  const auto add = [&](int i, int j) {
    const Vector3<Scalar> e =
        unit_between(r[static_cast<std::size_t>(i)], r[static_cast<std::size_t>(j)]);
    E.template block<3, 1>(3 * i, column) = -e;
    E.template block<3, 1>(3 * j, column) = e;
    ++column;
  };
  add(0, 1);
  add(1, 2);
  add(2, 0);
  for (int k = 3; k < n; ++k) {
    const std::vector<int> corners = pulled_corners(r, r[static_cast<std::size_t>(k)]);
    for (const int corner : corners) add(corner, k);
    if (corners.size() == 2) E.col(column++) = warp_forces(r, k);
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
    const Matrix<Scalar> E = linkage_forces(r);
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
/// grasp i act on the object at the grasp's point. For N >= 3 tensions and warps are E^+ f, the
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
