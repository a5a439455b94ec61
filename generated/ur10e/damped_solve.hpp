#ifndef TREELINE_UR10E_DAMPED_SOLVE_HPP
#define TREELINE_UR10E_DAMPED_SOLVE_HPP
// Forces of tasks where Lambda^-1 is nearly or wholly singular: selective damping by
// eigen-directions. C++17, freestanding, fixed size, same time for every matrix.
//
// Let S = diag(sqrt(heaviest_i)), where heaviest_i is the largest effective mass that row i of the
// task shall move: kg in rows of translation, kg m^2 in rows of rotation. S Lambda^-1 S has no
// unit; its eigenvalues, here called eases, fall below 1 in directions that feel heavier than that.
// With eases s_k and directions v_k, what is solved is
//
//     (Lambda^-1 + Delta) F = b,   Delta = S^-1 (sum_k delta(s_k) v_k v_k^T) S^-1,
//     delta(s) = (1 - s)^3 for s < 1, else 0.
//
// So b is missed by Delta F, which lies in heavy directions only: where none is, Delta is zero and
// F the LDL^T solution to the bit. F is a twice continuously differentiable function of Lambda^-1,
// since delta is one and the function of a matrix does not care how equal eigenvalues' directions
// mix: no step in torque. Because s + delta(s) >= 0.615 and s / (s + delta(s))^2 <= 1.362,
//
//     |S^-1 F| <= 1.626 |S b|,   qdd_F^T M qdd_F <= 1.362 |S b|^2,   qdd_F = M^-1 J^T F,
//
// at every configuration, singular ones included.

#include "ldlt.hpp"
#include "sin_cos.hpp"
#include "symmetric_eigen.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace ur10e::detail {

/// Bounds of `damped_solve`: of |S^-1 F| / |S b| and of qdd_F^T M qdd_F / |S b|^2.
inline constexpr double kLargestDampedForce = 1.6259;
inline constexpr double kLargestDampedEnergy = 1.3617;

/// delta(s) for directions that yield where s < border; border >= 1 is 1 but for rounding.
template <class Real>
constexpr Real damping_of(Real ease, Real border) noexcept {
  const Real difference = Real(1) - ease / border;
  const Real lack = difference > Real(0) ? difference : Real(0);
  return border * lack * lack * lack;
}

namespace steps {

/// x <- 1 / (s + delta(s)) x for each ease s. Returns the least ease; `yields` says whether any
/// delta is not 0. Eases above 1e13 (1e5 in float) leave no digit to those near 1; then the border
/// rises with them so that no quotient is one of rounding alone.
template <int N, class Real>
constexpr Real divide_by_eases(const Real (&eases)[N], Real (&x)[N], bool& yields) noexcept {
  Real least = eases[0];
  Real most = eases[0];
  for (int k = 1; k < N; ++k) {
    least = eases[k] < least ? eases[k] : least;
    most = eases[k] > most ? eases[k] : most;
  }
  const Real resolved = Real(64) * Format<Real>::kEpsilon * most;
  const Real border = resolved > Real(1) ? resolved : Real(1);
  yields = least < border;
  for (int k = 0; k < N; ++k) {
    x[k] = x[k] / (eases[k] + damping_of(eases[k], border));
  }
  return least;
}

}  // namespace steps

/// Turns `x`, which holds the accelerations b that are missing, into the forces F of
/// (A + Delta) F = b. The lower triangle of `A`, row-major, symmetric, positive semidefinite, is
/// Lambda^-1; `heaviest` are positive. Returns the least ease: 1 and more where nothing was added.
template <int N, int NN, class Real>
inline Real damped_solve(const Real (&A)[NN], const Real (&heaviest)[N], Real (&x)[N]) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  Real roots[N];
  Real turned[N];
  for (int i = 0; i < N; ++i) {
    roots[i] = steps::root(heaviest[i]);
    turned[i] = roots[i] * x[i];
  }
  steps::Turns<N, Real> turns;  // of S A S
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j <= i; ++j) {
      turns.reflections[i * N + j] = roots[i] * A[i * N + j] * roots[j];
    }
  }
  Real eases[N];
  steps::diagonalise(turns, eases);
  steps::turn(turns, turned);
  bool yields = false;
  const Real ease = steps::divide_by_eases(eases, turned, yields);
  steps::turn_back(turns, turned);
  // A, or where directions yield a matrix that has an inverse. By columns: of rows compilers make
  // calls of memcpy.
  for (int j = 0; j < N; ++j) {
    for (int i = j; i < N; ++i) {
      turns.reflections[i * N + j] = !yields ? A[i * N + j] : i == j ? Real(1) : Real(0);
    }
  }
  ldlt_factor<N>(turns.reflections);
  ldlt_solve(turns.reflections, x);
  for (int i = 0; i < N; ++i) {
    x[i] = yields ? roots[i] * turned[i] : x[i];
  }
  return ease;
}

/// tau += J^T F with F of (Lambda_inv + Delta) F = xdd_cmd - bias - J qdd_0: what makes Chang table
/// 6.1 of tau = RNEA(q, qd, qdd_0), for robots with `nv` velocities and tasks with `rows` rows.
/// Directions that yield leave their joint motions to qdd_0: let it damp (qdd_0 = -kv qd + ...),
/// or what the motion was on entering goes on. Returns the least ease.
template <int rows, int nv, int square, int size, class Real>
inline Real add_damped_task_torque(const Real (&Lambda_inv)[square], const Real (&J)[size],
                                   const Real (&bias)[rows], const Real (&qdd_0)[nv],
                                   const Real (&xdd_cmd)[rows], const Real (&heaviest)[rows],
                                   Real (&tau)[nv]) noexcept {
  static_assert(square == rows * rows && size == rows * nv, "matrices are row-major");
  Real F[rows];
  for (int row = 0; row < rows; ++row) {
    F[row] = xdd_cmd[row] - bias[row];
    for (int i = 0; i < nv; ++i) {
      F[row] -= J[row * nv + i] * qdd_0[i];
    }
  }
  const Real ease = damped_solve(Lambda_inv, heaviest, F);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < nv; ++i) {
      tau[i] += J[row * nv + i] * F[row];
    }
  }
  return ease;
}

}  // namespace ur10e::detail

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif  // TREELINE_UR10E_DAMPED_SOLVE_HPP
