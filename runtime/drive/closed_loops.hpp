#pragma once

#include <cmath>

#include "core/damped_solve.hpp"
#include "core/ldlt.hpp"
#include "servo/integrate.hpp"

namespace treeline::drive {

/// Factors a symmetric matrix that is positive semidefinite, with 1e-10 of its trace added to its
/// diagonal: rows that depend on others share their part. A matrix of zeros becomes the unit
/// matrix.
template <int n>
void factor_semidefinite(double (&A)[n * n]) noexcept {
  double trace = 0.0;
  for (int i = 0; i < n; ++i) {
    trace += A[i * n + i];
  }
  const double added = trace > 0.0 ? 1e-10 * trace : 1.0;
  for (int i = 0; i < n; ++i) {
    A[i * n + i] += added;
  }
  (void)core::ldlt_factor<n>(A);  // positive, or not finite, which shows in what it solves
}

/// Dynamics of a robot whose loops are closed, or that is held to the world. F offers generated
/// functions of the tree (`tree_inverse_dynamics`, `mass_matrix`) and of what holds it
/// (`constrained_forward_dynamics`, `constraint_jacobian`, and `constraint_errors` of loops), and
/// kPassive: velocities without a motor. Ideal forces hold a floating base that is not passive.
template <class F>
class ClosedLoops {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;
  static constexpr int kRows = F::kHeldRows;
  static constexpr int kWorldRows = F::kWorldRows;

  /// Motion under joint forces. What loops have opened, and `drift` of what is held to the world,
  /// is led back like a spring of 10 Hz with critical damping.
  static void forward_dynamics(const double (&q)[nq], const double (&qd)[nv],
                               const double (&tau)[nv], const double* drift,
                               double (&qdd)[nv]) noexcept {
    constexpr double kStabilisation[2] = {125.0, 3950.0};  // 1/s, 1/s^2
    double f[kRows];
    if constexpr (kWorldRows > 0) {
      double off[kWorldRows] = {};
      for (int i = 0; drift != nullptr && i < kWorldRows; ++i) {
        off[i] = drift[i];
      }
      F::constrained_forward_dynamics(q, qd, tau, kStabilisation, off, qdd, f);
    } else {
      (void)drift;
      F::constrained_forward_dynamics(q, qd, tau, kStabilisation, qdd, f);
    }
  }

  /// Forces of the motors for accelerations near `qdd`: those of joints without a motor follow from
  /// the others, and what is left that loops do not permit is taken away in the metric of M, by
  /// Gauss's principle. Where there are more motors than freedoms they share the load.
  static void inverse_dynamics(const double (&q)[nq], const double (&qd)[nv],
                               const double (&qdd)[nv], double (&tau)[nv]) noexcept {
    if constexpr (kPassiveCount == 0) {
      F::tree_inverse_dynamics(q, qd, qdd, tau);
    } else {
      const PassiveSide side(q, qd);
      double wanted[nv];
      double possible[nv];
      side.complete(qdd, wanted);
      F::tree_inverse_dynamics(q, qd, wanted, tau);
      forward_dynamics(q, qd, tau, nullptr, possible);
      F::tree_inverse_dynamics(q, qd, possible, tau);
      side.carry(tau);
    }
  }

  /// Forces of the motors that accelerate the rows of the task by `xdd`, with `posture` in what is
  /// free beside them, while all stays closed. Directions that feel heavier than
  /// F::kEffectiveMassLimits yield.
  static void control_torque(const double (&q)[nq], const double (&qd)[nv],
                             const double (&posture)[nv], const double* xdd,
                             double (&tau)[nv]) noexcept {
    if constexpr (F::kTaskRows > 0) {
      double qdd[nv];
      if constexpr (kPassiveCount == 0) {
        for (int i = 0; i < nv; ++i) qdd[i] = posture[i];
        add_task(q, qd, xdd, qdd);
        F::tree_inverse_dynamics(q, qd, qdd, tau);
      } else {
        const PassiveSide side(q, qd);
        side.complete(posture, qdd);
        add_task(q, qd, xdd, qdd);
        F::tree_inverse_dynamics(q, qd, qdd, tau);
        side.carry(tau);
      }
    }
  }

  /// The task's Jacobian of the motions that loops and constraints leave: J (1 - J_s^+ J_s).
  static void free_jacobian(const double (&q)[nq], double* J) noexcept {
    if constexpr (F::kTaskRows > 0) {
      double all[F::kTaskRows * nv];
      double held[kRows * nv];
      F::jacobian(q, all);
      F::constraint_jacobian(q, held);
      double A[kRows * kRows] = {};
      for (int i = 0; i < kRows * kRows; ++i) {
        for (int k = 0; k < nv; ++k) A[i] += held[i / kRows * nv + k] * held[i % kRows * nv + k];
      }
      factor_semidefinite<kRows>(A);
      for (int row = 0; row < F::kTaskRows; ++row) {
        double f[kRows] = {};
        for (int i = 0; i < kRows * nv; ++i) f[i / nv] += held[i] * all[row * nv + i % nv];
        core::ldlt_solve<kRows>(A, f);
        for (int k = 0; k < nv; ++k) {
          J[row * nv + k] = all[row * nv + k];
          for (int i = 0; i < kRows; ++i) J[row * nv + k] -= held[i * nv + k] * f[i];
        }
      }
    }
  }

  /// Closes the loops by Newton's method from `q`, mostly by joints without motors. Returns the
  /// largest error that is left, m or rad.
  static double close(double (&q)[nq]) noexcept {
    if constexpr (kLoopRows == 0) {
      (void)q;
      return 0.0;
    } else {
      constexpr int kSteps = 60;
      for (int step = 0; step < kSteps; ++step) {
        take_step(q);
      }
      double e[kLoopRows];
      F::constraint_errors(q, e);
      double largest = 0.0;
      for (const double error : e) {
        largest = std::fmax(largest, std::isfinite(error) ? std::fabs(error) : 1e9);
      }
      return largest;
    }
  }

 private:
  static constexpr int kPassiveCount = F::kPassiveCount;
  static constexpr int kLoopRows = kRows - kWorldRows;
  static constexpr int kRoom = kPassiveCount > 0 ? kPassiveCount : 1;

  /// The joints without a motor at a state: how what is held moves and carries them.
  class PassiveSide {
   public:
    PassiveSide(const double (&q)[nq], const double (&qd)[nv]) noexcept {
      F::constraint_jacobian(q, J_);
      held_accelerations(q, qd, J_, held_);
      for (int i = 0; i < kPassiveCount; ++i) {
        for (int j = 0; j < kPassiveCount; ++j) {
          for (int row = 0; row < kRows; ++row) {
            G_[i * kRoom + j] += column(row, i) * column(row, j);
          }
        }
      }
      factor_semidefinite<kRoom>(G_);
    }

    /// Accelerations with those of joints without a motor by least squares from the others:
    /// J_p qdd_p = -Jd qd - J_m qdd_m.
    void complete(const double (&given)[nv], double (&qdd)[nv]) const noexcept {
      for (int i = 0; i < nv; ++i) {
        qdd[i] = F::kPassive[i] ? 0.0 : given[i];
      }
      double x[kRoom] = {};
      for (int row = 0; row < kRows; ++row) {
        double missing = held_[row];
        for (int i = 0; i < nv; ++i) missing -= J_[row * nv + i] * qdd[i];
        for (int i = 0; i < kPassiveCount; ++i) x[i] += column(row, i) * missing;
      }
      core::ldlt_solve<kRoom>(G_, x);
      for (int i = 0; i < kPassiveCount; ++i) qdd[F::kPassiveVelocities[i]] = x[i];
    }

    /// Turns forces of all joints into those of the motors: what holds the robot carries the
    /// others, J_p^T f = tau_p, by the least f.
    void carry(double (&tau)[nv]) const noexcept {
      double x[kRoom] = {};
      for (int i = 0; i < kPassiveCount; ++i) x[i] = tau[F::kPassiveVelocities[i]];
      core::ldlt_solve<kRoom>(G_, x);
      for (int row = 0; row < kRows; ++row) {
        double f = 0.0;
        for (int i = 0; i < kPassiveCount; ++i) f += column(row, i) * x[i];
        for (int i = 0; i < nv; ++i) tau[i] -= J_[row * nv + i] * f;
      }
      for (int i = 0; i < kPassiveCount; ++i) tau[F::kPassiveVelocities[i]] = 0.0;
    }

   private:
    double column(int row, int i) const noexcept { return J_[row * nv + F::kPassiveVelocities[i]]; }
    double J_[kRows * nv];
    double held_[kRows];
    double G_[kRoom * kRoom] = {};
  };

  /// J qdd of every motion that is possible at a state: -Jd qd, and what leads loops back.
  static void held_accelerations(const double (&q)[nq], const double (&qd)[nv],
                                 const double (&J)[kRows * nv], double (&held)[kRows]) noexcept {
    const double none[nv] = {};
    double qdd[nv];
    forward_dynamics(q, qd, none, nullptr, qdd);
    for (int row = 0; row < kRows; ++row) {
      held[row] = 0.0;
      for (int i = 0; i < nv; ++i) held[row] += J[row * nv + i] * qdd[i];
    }
  }

  /// Rows of a Jacobian, and M^-1 J^T by rows.
  template <int rows>
  struct Rows {
    double J[rows * nv];
    double X[rows * nv];

    void divide(const double (&factors)[nv * nv]) noexcept {
      for (int row = 0; row < rows; ++row) {
        double x[nv];
        for (int i = 0; i < nv; ++i) x[i] = J[row * nv + i];
        core::ldlt_solve<nv>(factors, x);
        for (int i = 0; i < nv; ++i) X[row * nv + i] = x[i];
      }
    }
    /// Entry of J M^-1 J'^T: row `row` with the row `other` of another Jacobian.
    double along(int row, const double* other) const noexcept {
      double sum = 0.0;
      for (int i = 0; i < nv; ++i) sum += X[row * nv + i] * other[i];
      return sum;
    }
    double moved(int row, const double (&qdd)[nv]) const noexcept {
      double sum = 0.0;
      for (int i = 0; i < nv; ++i) sum += J[row * nv + i] * qdd[i];
      return sum;
    }
    template <int n>
    void push(const double (&f)[n], double (&qdd)[nv]) const noexcept {
      static_assert(n == rows);
      for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < nv; ++i) qdd[i] += X[row * nv + i] * f[row];
      }
    }
  };

  /// Takes from `qdd` what is not possible, and adds what the task needs beside that.
  static void add_task(const double (&q)[nq], const double (&qd)[nv], const double* xdd,
                       double (&qdd)[nv]) noexcept {
    double M[nv * nv];
    F::mass_matrix(q, M);
    (void)core::ldlt_factor<nv>(M);
    Rows<kRows> held;
    F::constraint_jacobian(q, held.J);
    held.divide(M);
    double A[kRows * kRows];
    for (int i = 0; i < kRows; ++i) {
      for (int j = 0; j < kRows; ++j) A[i * kRows + j] = held.along(i, held.J + j * nv);
    }
    factor_semidefinite<kRows>(A);
    double f[kRows];
    held_accelerations(q, qd, held.J, f);
    for (int row = 0; row < kRows; ++row) f[row] -= held.moved(row, qdd);
    core::ldlt_solve<kRows>(A, f);
    held.push(f, qdd);
    push_task(q, qd, xdd, M, held, A, qdd);
  }

  static void push_task(const double (&q)[nq], const double (&qd)[nv], const double* xdd,
                        const double (&M)[nv * nv], const Rows<kRows>& held,
                        const double (&A)[kRows * kRows], double (&qdd)[nv]) noexcept {
    constexpr int rows = F::kTaskRows;
    Rows<rows> task;
    F::jacobian(q, task.J);
    task.divide(M);
    for (int row = 0; row < rows; ++row) {  // X of motions that what is held permits
      double f[kRows];
      for (int k = 0; k < kRows; ++k) f[k] = held.along(k, task.J + row * nv);
      core::ldlt_solve<kRows>(A, f);
      for (int k = 0; k < kRows; ++k) {
        for (int i = 0; i < nv; ++i) task.X[row * nv + i] -= held.X[k * nv + i] * f[k];
      }
    }
    double Lambda_inv[rows * rows];
    double missing[rows];
    F::bias_acceleration(q, qd, missing);
    for (int i = 0; i < rows; ++i) {
      missing[i] = xdd[i] - missing[i] - task.moved(i, qdd);
      for (int j = 0; j < rows; ++j) Lambda_inv[i * rows + j] = task.along(i, task.J + j * nv);
    }
    core::damped_solve(Lambda_inv, F::kEffectiveMassLimits, missing);
    task.push(missing, qdd);
  }

  /// q moves by -W J^T (J W J^T)^-1 e, each joint by a bounded way; W favours joints without
  /// motors.
  static void take_step(double (&q)[nq]) noexcept {
    constexpr double kLongest = 0.3;  // rad or m
    const auto weight = [](int i) { return F::kPassive[i] ? 1.0 : 1e-3; };
    double e[kLoopRows];
    double all[kRows * nv];
    F::constraint_errors(q, e);
    F::constraint_jacobian(q, all);
    const double* const J = all + kWorldRows * nv;
    double A[kLoopRows * kLoopRows] = {};
    for (int i = 0; i < kLoopRows; ++i) {
      for (int j = 0; j < kLoopRows; ++j) {
        for (int k = 0; k < nv; ++k) {
          A[i * kLoopRows + j] += J[i * nv + k] * weight(k) * J[j * nv + k];
        }
      }
    }
    factor_semidefinite<kLoopRows>(A);
    core::ldlt_solve<kLoopRows>(A, e);
    double way[nv] = {};
    for (int k = 0; k < nv; ++k) {
      for (int i = 0; i < kLoopRows; ++i) way[k] -= weight(k) * J[i * nv + k] * e[i];
      way[k] = std::fmax(-kLongest, std::fmin(kLongest, way[k]));
    }
    double rates[nq];
    servo::coordinate_rates<nq, nv>(F::kFloating, q, way, rates);
    for (int i = 0; i < nq; ++i) q[i] += rates[i];
    servo::normalise_quaternions<nq, nv>(F::kFloating, q);
  }
};

}  // namespace treeline::drive
