#pragma once

#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/methods/task_basis.hpp"

namespace treeline {

template <class Scalar>
Vector3<Scalar> triple(const DenseMatrix<Scalar>& A, std::size_t row, std::size_t col) {
  return {A(row, col), A(row, col + 1), A(row, col + 2)};
}

/// Moves the diagonal block of one point to the point at r: with L' = L - [r]x A for velocities,
/// LA' = LA - [r]x AA and LL'_ij = LL_ij - (r x LA_j)_i - (r x LA'_i)_j. The rows start at `first`.
template <class Scalar>
void shift_diagonal_block(DenseMatrix<Scalar>& A, std::size_t first, const Vector3<Scalar>& r) {
  const std::size_t a = first + 3;
  Vector3<Scalar> LA[3];
  Vector3<Scalar> moved[3];
  for (std::size_t i = 0; i < 3; ++i) {
    LA[i] = triple(A, first + i, a);
  }
  const Vector3<Scalar> AA[3] = {triple(A, a, a), triple(A, a + 1, a), triple(A, a + 2, a)};
  const auto minus_cross = [](const Vector3<Scalar>& from, const Scalar& s,
                              const Vector3<Scalar>& u, const Scalar& t,
                              const Vector3<Scalar>& v) { return from - (u * s - v * t); };
  moved[0] = minus_cross(LA[0], r.y, AA[2], r.z, AA[1]);
  moved[1] = minus_cross(LA[1], r.z, AA[0], r.x, AA[2]);
  moved[2] = minus_cross(LA[2], r.x, AA[1], r.y, AA[0]);
  const Vector3<Scalar> both[3] = {LA[0] + moved[0], LA[1] + moved[1], LA[2] + moved[2]};
  A(first, first) = A(first, first) - (r.y * both[0].z - r.z * both[0].y);
  A(first + 1, first + 1) = A(first + 1, first + 1) - (r.z * both[1].x - r.x * both[1].z);
  A(first + 2, first + 2) = A(first + 2, first + 2) - (r.x * both[2].y - r.y * both[2].x);
  const Scalar yx = (r.y * LA[1].z - r.z * LA[1].y) + (r.z * moved[0].x - r.x * moved[0].z);
  const Scalar zx = (r.y * LA[2].z - r.z * LA[2].y) + (r.x * moved[0].y - r.y * moved[0].x);
  const Scalar zy = (r.z * LA[2].x - r.x * LA[2].z) + (r.x * moved[1].y - r.y * moved[1].x);
  const auto set_pair = [&A](std::size_t i, std::size_t j, const Scalar& value) {
    A(i, j) = A(j, i) = value;
  };
  set_pair(first + 1, first, A(first + 1, first) - yx);
  set_pair(first + 2, first, A(first + 2, first) - zx);
  set_pair(first + 2, first + 1, A(first + 2, first + 1) - zy);
  for (std::size_t i = 0; i < 3; ++i) {
    set_pair(first + i, a, moved[i].x);
    set_pair(first + i, a + 1, moved[i].y);
    set_pair(first + i, a + 2, moved[i].z);
  }
}

/// Moves the block between two points: rows by their own r, then columns by theirs.
template <class Scalar>
void shift_coupling_block(DenseMatrix<Scalar>& A, std::size_t row, const Vector3<Scalar>& r_row,
                          std::size_t col, const Vector3<Scalar>& r_col) {
  for (std::size_t j = col; j < col + 6; ++j) {
    const Vector3<Scalar> angular{A(row + 3, j), A(row + 4, j), A(row + 5, j)};
    const Vector3<Scalar> gain = cross(r_row, angular);
    A(row, j) = A(row, j) - gain.x;
    A(row + 1, j) = A(row + 1, j) - gain.y;
    A(row + 2, j) = A(row + 2, j) - gain.z;
  }
  for (std::size_t i = row; i < row + 6; ++i) {
    const Vector3<Scalar> gain = cross(r_col, triple(A, i, col + 3));
    A(i, col) = A(i, col) - gain.x;
    A(i, col + 1) = A(i, col + 1) - gain.y;
    A(i, col + 2) = A(i, col + 2) - gain.z;
    for (std::size_t j = col; j < col + 6; ++j) {
      A(j, i) = A(i, j);
    }
  }
}

/// Moves Lambda^-1 from link origins to the operational points. All rows must be present, in the
/// axes of `basis`.
template <class Scalar>
void shift_to_points(const Tree<Scalar>& tree, TaskBasis basis,
                     const std::vector<WorldPose<Scalar>>& poses, DenseMatrix<Scalar>& Lambda_inv) {
  std::vector<Vector3<Scalar>> arms;
  for (const TreePoint<Scalar>& point : tree.operational_points) {
    arms.push_back(task_from_link(point, basis, poses) * point.p);
  }
  for (std::size_t i = 0; i < arms.size(); ++i) {
    shift_diagonal_block(Lambda_inv, 6 * i, arms[i]);
    for (std::size_t j = 0; j < i; ++j) {
      shift_coupling_block(Lambda_inv, 6 * i, arms[i], 6 * j, arms[j]);
    }
  }
}

}  // namespace treeline
