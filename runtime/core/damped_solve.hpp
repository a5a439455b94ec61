#pragma once
// Forces of tasks where Lambda^-1 is nearly or wholly singular: selective damping by
// eigen-directions, see runtime/emitted/damped_solve.h. C++17, freestanding, fixed size, same time
// for every matrix.

#include "core/emitted_damped.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Bounds of `damped_solve`: of |S^-1 F| / |S b| and of qdd_F^T M qdd_F / |S b|^2.
inline constexpr double kLargestDampedForce = 1.6259;
inline constexpr double kLargestDampedEnergy = 1.3617;

/// Turns `x`, which holds the accelerations b that are missing, into the forces F of
/// (A + Delta) F = b. The lower triangle of `A`, row-major, symmetric, positive semidefinite, is
/// Lambda^-1; `heaviest` are positive. Returns the least ease: 1 and more where nothing was added.
template <int N, int NN, class Real>
inline Real damped_solve(const Real (&A)[NN], const Real (&heaviest)[N], Real (&x)[N]) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  return EmittedDamped<Real, N>::tl_damped_solve(A, heaviest, x);
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
  return EmittedDamped<Real, rows, nv>::tl_add_damped_task_torque(Lambda_inv, J, bias, qdd_0,
                                                                  xdd_cmd, heaviest, tau);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
