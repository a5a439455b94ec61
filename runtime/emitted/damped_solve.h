#pragma once
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

#include "ldlt.h"
#include "symmetric_eigen.h"

/// delta(s) for directions that yield where s < border; border >= 1 is 1 but for
/// rounding.
TL_INLINE real tl_damping_of(real ease, real border) {
  const real difference = TL_ONE - (ease / border);
  const real lack = (difference > TL_ZERO) ? difference : TL_ZERO;
  return border * lack * lack * lack;
}

/// x <- 1 / (s + delta(s)) x for each ease s. Returns the least ease; yields says
/// whether any delta is not 0. Very large eases leave no digit to those near 1
/// (beyond 1e13, in float 1e5); then the border rises with them so that no quotient
/// is one of rounding alone.
TL_INLINE real tl_divide_by_eases(const real* eases, real* x, bool* yields) {
  real least = eases[0];
  real most = eases[0];
  for (int32_t k = 1; k < TL_TASK_ROWS; ++k) {
    least = (eases[k] < least) ? eases[k] : least;
    most = (eases[k] > most) ? eases[k] : most;
  }
  const real resolved = TL_UNRESOLVED * most;
  const real border = (resolved > TL_ONE) ? resolved : TL_ONE;
  *yields = least < border;
  for (int32_t k = 0; k < TL_TASK_ROWS; ++k) {
    x[k] = x[k] / (eases[k] + tl_damping_of(eases[k], border));
  }
  return least;
}

/// Turns x, which holds the accelerations b that are missing, into the forces F of
/// (A + Delta) F = b. The lower triangle of A, row-major, symmetric, positive
/// semidefinite, is Lambda^-1; heaviest are positive. Returns the least ease: 1 and
/// more where nothing was added.
TL_INLINE real tl_damped_solve(const real* A, const real* heaviest, real* x) {
  real roots[TL_TASK_ROWS];
  real turned[TL_TASK_ROWS];
  for (int32_t i = 0; i < TL_TASK_ROWS; ++i) {
    roots[i] = tl_root(heaviest[i]);
    turned[i] = roots[i] * x[i];
  }
  TlTurns turns;  // of S A S
  for (int32_t i = 0; i < TL_TASK_ROWS; ++i) {
    for (int32_t j = 0; j <= i; ++j) {
      turns.reflections[(i * TL_TASK_ROWS) + j] =
          roots[i] * A[(i * TL_TASK_ROWS) + j] * roots[j];
    }
  }
  real eases[TL_TASK_ROWS];
  tl_diagonalise(&turns, &eases[0]);
  tl_turn(&turns, &turned[0]);
  bool yields = false;
  const real ease = tl_divide_by_eases(&eases[0], &turned[0], &yields);
  tl_turn_back(&turns, &turned[0]);
  // A, or where directions yield a matrix that has an inverse. By columns: of rows
  // compilers make calls of memcpy.
  for (int32_t j = 0; j < TL_TASK_ROWS; ++j) {
    for (int32_t i = j; i < TL_TASK_ROWS; ++i) {
      const real unit = (i == j) ? TL_ONE : TL_ZERO;
      turns.reflections[(i * TL_TASK_ROWS) + j] =
          yields ? unit : A[(i * TL_TASK_ROWS) + j];
    }
  }
  (void)tl_ldlt_factor(&turns.reflections[0]);
  tl_ldlt_solve(&turns.reflections[0], x);
  for (int32_t i = 0; i < TL_TASK_ROWS; ++i) {
    x[i] = yields ? (roots[i] * turned[i]) : x[i];
  }
  return ease;
}

/// tau += J^T F with F of (Lambda_inv + Delta) F = xdd_cmd - bias - J qdd_0: what
/// makes Chang table 6.1 of tau = RNEA(q, qd, qdd_0). Directions that yield leave
/// their joint motions to qdd_0: let it damp (qdd_0 = -kv qd + ...), or what the
/// motion was on entering goes on. Returns the least ease.
TL_INLINE real tl_add_damped_task_torque(const real* Lambda_inv, const real* J,
    const real* bias, const real* qdd_0, const real* xdd_cmd, const real* heaviest,
    real* tau) {
  real F[TL_TASK_ROWS];
  for (int32_t row = 0; row < TL_TASK_ROWS; ++row) {
    F[row] = xdd_cmd[row] - bias[row];
    for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
      F[row] -= J[(row * TL_VELOCITIES) + i] * qdd_0[i];
    }
  }
  const real ease = tl_damped_solve(Lambda_inv, heaviest, &F[0]);
  for (int32_t row = 0; row < TL_TASK_ROWS; ++row) {
    for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
      tau[i] += J[(row * TL_VELOCITIES) + i] * F[row];
    }
  }
  return ease;
}
