#pragma once

#include <cstddef>
#include <vector>

#include "interpreter/points.hpp"

namespace treeline::interpreter {

/// Shares to which tasks are done, by row, and the point of each row.
template <class Scalar>
struct TaskShares {
  Vector<Scalar> s;
  std::vector<int> point;
};

template <class Scalar>
TaskShares<Scalar> task_shares(PointsArg<Scalar> points) {
  TaskShares<Scalar> shares{Vector<Scalar>(row_count<Scalar>(points)), {}};
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const bool row : points[k].rows) {
      if (!row) continue;
      shares.s(static_cast<Eigen::Index>(shares.point.size())) = points[k].share;
      shares.point.push_back(static_cast<int>(k));
    }
  }
  return shares;
}

/// S A S of tasks that act and see s-fold, S = diag(s), with the compliance 1 - s^2 of A in the
/// rows of each point. With s > 0 this is S (A + (1 - s^2) / s^2 A_ii) S, so that F = S A'^-1 S e
/// solves (A + (1 - s^2) / s^2 A_ii) F = e; with s = 0, F is 0.
template <class Scalar>
Matrix<Scalar> with_shares(const Matrix<Scalar>& A, const TaskShares<Scalar>& shares) {
  Matrix<Scalar> shared = shares.s.asDiagonal() * A * shares.s.asDiagonal();
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      if (shares.point[static_cast<std::size_t>(i)] != shares.point[static_cast<std::size_t>(j)]) {
        continue;
      }
      shared(i, j) += (Scalar(1) - shares.s(i) * shares.s(j)) * A(i, j);
    }
  }
  return shared;
}

}  // namespace treeline::interpreter
