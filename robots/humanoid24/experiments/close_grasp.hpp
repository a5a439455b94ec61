#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace treeline::experiments {

/// Moves `q` by the least change of joint coordinates to where the grasps of the object agree, by
/// Newton's method with a Jacobian from central differences. For starts that are given by rounded
/// figures. F::drift(q, e) gives the kDrift entries of the grasps' drift. All joints must have one
/// degree of freedom. Returns the largest remaining entry.
template <class F, int nq>
double close_grasp(double (&q)[nq]) {
  constexpr int kRows = F::kDrift;
  constexpr double kStep = 1e-6;
  double e[kRows];
  for (int iteration = 0; iteration < 20; ++iteration) {
    F::drift(q, e);
    Eigen::Matrix<double, kRows, nq> J;
    for (int i = 0; i < nq; ++i) {
      const double at = q[i];
      double ahead[kRows];
      double behind[kRows];
      q[i] = at + kStep;
      F::drift(q, ahead);
      q[i] = at - kStep;
      F::drift(q, behind);
      q[i] = at;
      for (int row = 0; row < kRows; ++row) {
        J(row, i) = (ahead[row] - behind[row]) / (2.0 * kStep);
      }
    }
    const Eigen::Map<const Eigen::Matrix<double, kRows, 1>> error(e);
    const Eigen::Matrix<double, nq, 1> step =
        J.transpose() * (J * J.transpose()).ldlt().solve(error);
    for (int i = 0; i < nq; ++i) {
      q[i] -= step(i);
    }
  }
  F::drift(q, e);
  double worst = 0.0;
  for (const double entry : e) {
    worst = std::max(worst, std::abs(entry));
  }
  return worst;
}

}  // namespace treeline::experiments
