// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_DAMPED_SOLVE_HPP
#define TREELINE_UR10E_DAMPED_SOLVE_HPP
// Forces of tasks where Lambda^-1 is nearly or wholly singular: selective damping by
// eigen-directions, the same time for every matrix.
//
// Let S = diag(sqrt(heaviest_i)), where heaviest_i is the largest effective mass that
// row i of the task shall move: kg in rows of translation, kg m^2 in rows of
// rotation. S Lambda^-1 S has no unit; its eigenvalues, here called eases, fall below
// 1 in directions that feel heavier than that. With eases s_k and directions v_k,
// what is solved is
//
//     (Lambda^-1 + Delta) F = b,   Delta = S^-1 (sum_k delta(s_k) v_k v_k^T) S^-1,
//     delta(s) = (1 - s)^3 for s < 1, else 0.
//
// So b is missed by Delta F, which lies in heavy directions only: where none is,
// Delta is zero and F the LDL^T solution to the bit. F is a twice continuously
// differentiable function of Lambda^-1, since delta is one and the function of a
// matrix does not care how equal eigenvalues' directions mix: no step in torque.
// Because s + delta(s) >= 0.615 and s / (s + delta(s))^2 <= 1.362,
//
//     |S^-1 F| <= 1.626 |S b|,
//     qdd_F^T M qdd_F <= 1.362 |S b|^2,   qdd_F = M^-1 J^T F,
//
// at every configuration, singular ones included.
// Generated; see ur10e_damped.hpp for the contract.

#include "ldlt.hpp"
#include "symmetric_eigen.hpp"

namespace ur10e {
namespace detail {

/// delta(s) for directions that yield where s < border; border >= 1 is 1 but for
/// rounding.
inline double damping_of(double ease, double border) {
  const double difference = 1.0 - (ease / border);
  const double lack = (difference > 0.0) ? difference : 0.0;
  return border * lack * lack * lack;
}

/// x <- 1 / (s + delta(s)) x for each ease s. Returns the least ease; yields says
/// whether any delta is not 0. Very large eases leave no digit to those near 1
/// (beyond 1e13, in float 1e5); then the border rises with them so that no quotient
/// is one of rounding alone.
inline double divide_by_eases(const double* eases, double* x, bool* yields) {
  double least = eases[0];
  double most = eases[0];
  for (int32_t k = 1; k < kTaskRows; ++k) {
    least = (eases[k] < least) ? eases[k] : least;
    most = (eases[k] > most) ? eases[k] : most;
  }
  const double resolved = 0x1p-46 * most;
  const double border = (resolved > 1.0) ? resolved : 1.0;
  *yields = least < border;
  for (int32_t k = 0; k < kTaskRows; ++k) {
    x[k] = x[k] / (eases[k] + damping_of(eases[k], border));
  }
  return least;
}

/// Turns x, which holds the accelerations b that are missing, into the forces F of
/// (A + Delta) F = b. The lower triangle of A, row-major, symmetric, positive
/// semidefinite, is Lambda^-1; heaviest are positive. Returns the least ease: 1 and
/// more where nothing was added.
inline double damped_solve(const double* A, const double* heaviest, double* x) {
  double roots[kTaskRows];
  double turned[kTaskRows];
  for (int32_t i = 0; i < kTaskRows; ++i) {
    roots[i] = root(heaviest[i]);
    turned[i] = roots[i] * x[i];
  }
  Turns turns;  // of S A S
  for (int32_t i = 0; i < kTaskRows; ++i) {
    for (int32_t j = 0; j <= i; ++j) {
      turns.reflections[(i * kTaskRows) + j] =
          roots[i] * A[(i * kTaskRows) + j] * roots[j];
    }
  }
  double eases[kTaskRows];
  diagonalise(&turns, &eases[0]);
  turn(&turns, &turned[0]);
  bool yields = false;
  const double ease = divide_by_eases(&eases[0], &turned[0], &yields);
  turn_back(&turns, &turned[0]);
  // A, or where directions yield a matrix that has an inverse. By columns: of rows
  // compilers make calls of memcpy.
  for (int32_t j = 0; j < kTaskRows; ++j) {
    for (int32_t i = j; i < kTaskRows; ++i) {
      const double unit = (i == j) ? 1.0 : 0.0;
      turns.reflections[(i * kTaskRows) + j] =
          yields ? unit : A[(i * kTaskRows) + j];
    }
  }
  (void)ldlt_factor(&turns.reflections[0]);
  ldlt_solve(&turns.reflections[0], x);
  for (int32_t i = 0; i < kTaskRows; ++i) {
    x[i] = yields ? (roots[i] * turned[i]) : x[i];
  }
  return ease;
}

/// tau += J^T F with F of (Lambda_inv + Delta) F = xdd_cmd - bias - J qdd_0: what
/// makes Chang table 6.1 of tau = RNEA(q, qd, qdd_0). Directions that yield leave
/// their joint motions to qdd_0: let it damp (qdd_0 = -kv qd + ...), or what the
/// motion was on entering goes on. Returns the least ease.
inline double add_damped_task_torque(const double* Lambda_inv, const double* J,
    const double* bias, const double* qdd_0, const double* xdd_cmd, const double* heaviest,
    double* tau) {
  double F[kTaskRows];
  for (int32_t row = 0; row < kTaskRows; ++row) {
    F[row] = xdd_cmd[row] - bias[row];
    for (int32_t i = 0; i < kVelocities; ++i) {
      F[row] -= J[(row * kVelocities) + i] * qdd_0[i];
    }
  }
  const double ease = damped_solve(Lambda_inv, heaviest, &F[0]);
  for (int32_t row = 0; row < kTaskRows; ++row) {
    for (int32_t i = 0; i < kVelocities; ++i) {
      tau[i] += J[(row * kVelocities) + i] * F[row];
    }
  }
  return ease;
}

}  // namespace detail
}  // namespace ur10e

#endif  // TREELINE_UR10E_DAMPED_SOLVE_HPP
