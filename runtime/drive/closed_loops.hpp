#pragma once

#include <cmath>

#include "core/ldlt.hpp"

namespace treeline::drive {

/// Solves A x = b for a symmetric matrix that is positive semidefinite, with 1e-10 of its trace
/// added to its diagonal: rows that depend on others share their part. `x` holds b on entry.
template <int n>
void solve_semidefinite(double (&A)[n * n], double (&x)[n]) noexcept {
  double trace = 0.0;
  for (int i = 0; i < n; ++i) {
    trace += A[i * n + i];
  }
  for (int i = 0; i < n; ++i) {
    A[i * n + i] += 1e-10 * trace;
  }
  (void)core::ldlt_factor<n>(A);  // positive, or not finite, which shows in x
  core::ldlt_solve<n>(A, x);
}

/// Dynamics of a robot with closed loops. F offers `constrained_forward_dynamics`,
/// `constraint_errors` and `constraint_jacobian` of its generated code, and kMotors: the velocities
/// that motors move.
template <class F>
class ClosedLoops {
 public:
  static constexpr int nv = F::kVelocities;

  /// Motion under joint forces, with what loops have opened led back like a spring of 10 Hz with
  /// critical damping.
  static void forward_dynamics(const double (&q)[nv], const double (&qd)[nv],
                               const double (&tau)[nv], double (&qdd)[nv]) noexcept {
    constexpr double kStabilisation[2] = {125.0, 3950.0};  // 1/s, 1/s^2
    double f[F::kHeldRows];
    F::constrained_forward_dynamics(q, qd, tau, kStabilisation, qdd, f);
  }

  /// Forces of the motors under which their joints accelerate as `qdd` says; entries of other
  /// joints play no part. Forward dynamics is affine in the forces: the matrix of the motors is
  /// symmetric. Where there are more motors than freedoms they share the load.
  static void inverse_dynamics(const double (&q)[nv], const double (&qd)[nv],
                               const double (&qdd)[nv], double (&tau)[nv]) noexcept {
    double free[nv];
    const double none[nv] = {};
    forward_dynamics(q, qd, none, free);
    double A[kMotors * kMotors];
    double forces[kMotors];
    for (int j = 0; j < kMotors; ++j) {
      double unit[nv] = {};
      unit[F::kMotors[j]] = 1.0;
      double moved[nv];
      forward_dynamics(q, qd, unit, moved);
      for (int i = 0; i < kMotors; ++i) {
        A[i * kMotors + j] = moved[F::kMotors[i]] - free[F::kMotors[i]];
      }
      forces[j] = qdd[F::kMotors[j]] - free[F::kMotors[j]];
    }
    solve_semidefinite<kMotors>(A, forces);
    for (int i = 0; i < nv; ++i) {
      tau[i] = 0.0;
    }
    for (int j = 0; j < kMotors; ++j) {
      tau[F::kMotors[j]] = forces[j];
    }
  }

  /// Closes the loops by Newton's method from `q`, mostly by joints without motors. Returns the
  /// largest error that is left, m or rad.
  static double close(double (&q)[nv]) noexcept {
    constexpr int kSteps = 60;
    double weights[nv];
    for (double& weight : weights) {
      weight = 1.0;
    }
    for (const int motor : F::kMotors) {
      weights[motor] = 1e-3;
    }
    for (int step = 0; step < kSteps; ++step) {
      take_step(weights, q);
    }
    double e[kRows];
    F::constraint_errors(q, e);
    double largest = 0.0;
    for (const double error : e) {
      largest = std::fmax(largest, std::fabs(error));
    }
    return std::isfinite(largest) ? largest : 1e9;
  }

 private:
  static constexpr int kMotors = F::kMotorCount;
  static constexpr int kRows = F::kHeldRows;

  /// q -= W J^T (J W J^T)^-1 e, each joint by a bounded way.
  static void take_step(const double (&weights)[nv], double (&q)[nv]) noexcept {
    constexpr double kLongest = 0.3;  // rad or m
    double e[kRows];
    double J[kRows * nv];
    F::constraint_errors(q, e);
    F::constraint_jacobian(q, J);
    double A[kRows * kRows] = {};
    for (int i = 0; i < kRows; ++i) {
      for (int j = 0; j < kRows; ++j) {
        for (int k = 0; k < nv; ++k) {
          A[i * kRows + j] += J[i * nv + k] * weights[k] * J[j * nv + k];
        }
      }
    }
    solve_semidefinite<kRows>(A, e);
    for (int k = 0; k < nv; ++k) {
      double change = 0.0;
      for (int i = 0; i < kRows; ++i) {
        change -= weights[k] * J[i * nv + k] * e[i];
      }
      q[k] += std::fmax(-kLongest, std::fmin(kLongest, change));
    }
  }
};

}  // namespace treeline::drive
