#pragma once
// Control at kinematic singularities (Chang appendix A; Chang & Khatib, IROS 1995). C++17,
// freestanding, fixed size; everything stays bounded at, near and far from a singularity.
//
// The Jacobian of a robot, its rows scaled to be comparable, has singular values sigma_i with
// directions u_i of the task and motions n_i of the joints: u_i^T J n_i = sigma_i. Where sigma_i
// falls below a border, direction u_i leaves the task space and the joints gain the motion n_i, the
// rest of the task stays fully controlled. Moving along n_i
//   type 1: changes sigma_i, and to second order moves the tip along u_i (elbow lock, head lock),
//   type 2: leaves sigma_i zero and only turns u_i (wrist lock).
// So type 1 is left along n_i, and in type 2 u_i is turned away from the wanted motion.

#include "core/prioritized_solve.hpp"
#include "core/symmetric_eigen.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Region in which a direction begins to be lost (outer) and is lost (inner): singular values of
/// the scaled Jacobian, 0 < inner < outer.
template <class Real>
struct SingularRegion {
  Real inner = Real(0.02);
  Real outer = Real(0.06);
};

/// The scaled Jacobian taken apart; rows <= nv.
template <int rows, int nv, class Real>
struct SingularDirections {
  Real values[rows];             ///< sigma_i, descending
  Real directions[rows * rows];  ///< row i: u_i, in the scaled rows
  Real motions[nv * nv];         ///< row i: n_i; from row `rows` on the null space
  Real shares[rows];             ///< 1 outside of the region, 0 in its interior, smooth
};

/// J = diag(1 / scales) J_given: `scales` is for each row the length (m) that counts like a turn by
/// 1 rad, and 1 for angular rows.
template <int rows, int nv, int size, class Real>
constexpr void scale_rows(const Real (&J_given)[size], const Real (&scales)[rows],
                          Real (&J)[size]) noexcept {
  static_assert(size == rows * nv, "J holds rows x nv numbers");
  for (int i = 0; i < size; ++i) {
    J[i] = J_given[i] / scales[i / nv];
  }
}

/// Singular values and both sets of directions of the scaled Jacobian `J` by the eigenproblems of
/// J J^T and J^T J. Accurate to the square root of a rounding: far below any useful border. Where
/// two values are equal their directions mix.
template <int rows, int nv, int size, class Real>
inline SingularDirections<rows, nv, Real> singular_directions(
    const Real (&J)[size], const SingularRegion<Real>& region) noexcept {
  static_assert(size == rows * nv && rows <= nv, "J holds rows x nv numbers, rows <= nv");
  Real JJt[rows * rows];
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      Real sum = Real(0);
      for (int k = 0; k < nv; ++k) {
        sum += J[i * nv + k] * J[j * nv + k];
      }
      JJt[i * rows + j] = sum;
    }
  }
  Real JtJ[nv * nv];
  for (int k = 0; k < nv; ++k) {
    for (int l = 0; l < nv; ++l) {
      Real sum = Real(0);
      for (int i = 0; i < rows; ++i) {
        sum += J[i * nv + k] * J[i * nv + l];
      }
      JtJ[k * nv + l] = sum;
    }
  }
  SingularDirections<rows, nv, Real> found;
  Real squares[nv];
  steps::decompose<nv>(JtJ, squares, found.motions);
  steps::sort_descending(squares, found.motions);
  steps::decompose<rows>(JJt, found.values, found.directions);
  steps::sort_descending(found.values, found.directions);
  for (int i = 0; i < rows; ++i) {
    found.values[i] = steps::root(found.values[i]);
    found.shares[i] = smooth_step((found.values[i] - region.inner) / (region.outer - region.inner));
  }
  return found;
}

/// The motion n of lost direction `i`, a unit vector of joint velocities: of all motions that the
/// rest of the task does not see (n_i and, in a redundant robot, the null space) the nearest to
/// `reference`, which also gives its sign. Where the reference is no help, n_i itself.
template <int rows, int nv, class Real>
inline void lost_motion(const SingularDirections<rows, nv, Real>& found, int i,
                        const Real (&reference)[nv], Real (&n)[nv]) noexcept {
  for (int row = i; row < nv; row = row < rows ? rows : row + 1) {
    Real along = Real(0);
    for (int k = 0; k < nv; ++k) {
      along += found.motions[row * nv + k] * reference[k];
    }
    for (int k = 0; k < nv; ++k) {
      n[k] = (row == i ? Real(0) : n[k]) + along * found.motions[row * nv + k];
    }
  }
  Real square = Real(0);
  for (int k = 0; k < nv; ++k) {
    square += n[k] * n[k];
  }
  const bool helps = square > Real(1e-8);
  const Real length = helps ? steps::root(square) : Real(1);
  for (int k = 0; k < nv; ++k) {
    n[k] = helps ? n[k] / length : found.motions[i * nv + k];
  }
}

/// How the lost direction u answers a motion n of the joints, each per rad of it.
template <int rows, class Real>
struct LostDirection {
  Real sigma = Real(0);      ///< u^T J n, signed
  Real curvature = Real(0);  ///< u^T dJ n: sigma's rate; half of it times s^2 is the motion along u
  Real turn[rows];           ///< du/ds
};

/// `J` scaled, `dJ` its change per rad along n. By perturbation of eigenvectors: du has the
/// component u_k^T d(J J^T) u / (sigma_i^2 - sigma_k^2) along u_k, taken as none for equal values.
template <int rows, int nv, int size, class Real>
inline LostDirection<rows, Real> lost_direction(const SingularDirections<rows, nv, Real>& found,
                                                int i, const Real (&J)[size],
                                                const Real (&dJ)[size],
                                                const Real (&n)[nv]) noexcept {
  static_assert(size == rows * nv, "J holds rows x nv numbers");
  const auto project = [&found](int row, const Real(&matrix)[size], Real(&result)[nv]) noexcept {
    for (int k = 0; k < nv; ++k) {
      result[k] = Real(0);
      for (int j = 0; j < rows; ++j) {
        result[k] += found.directions[row * rows + j] * matrix[j * nv + k];
      }
    }
  };
  Real Jt_u[nv];
  Real dJt_u[nv];
  project(i, J, Jt_u);
  project(i, dJ, dJt_u);
  LostDirection<rows, Real> lost;
  for (int k = 0; k < nv; ++k) {
    lost.sigma += Jt_u[k] * n[k];
    lost.curvature += dJt_u[k] * n[k];
  }
  const Real own = found.values[i] * found.values[i];
  Real components[rows];  // of du
  for (int other = 0; other < rows; ++other) {
    Real Jt_other[nv];
    Real dJt_other[nv];
    project(other, J, Jt_other);
    project(other, dJ, dJt_other);
    Real change = Real(0);
    for (int k = 0; k < nv; ++k) {
      change += dJt_other[k] * Jt_u[k] + Jt_other[k] * dJt_u[k];
    }
    const Real gap = own - found.values[other] * found.values[other];
    const bool apart = other != i && gap * gap > Real(1e-12);
    components[other] = apart ? change / gap : Real(0);
  }
  for (int j = 0; j < rows; ++j) {
    lost.turn[j] = Real(0);
    for (int other = 0; other < rows; ++other) {
      lost.turn[j] += components[other] * found.directions[other * rows + j];
    }
  }
  return lost;
}

enum class SingularityType { none, moves_along, turns };  ///< neither, type 1, type 2

/// Type 1 where the null motion moves along the lost direction by `threshold` (scaled rows per
/// rad^2) or more, else type 2 where it turns it by as much (rad per rad).
template <int rows, class Real>
inline SingularityType singularity_type(const LostDirection<rows, Real>& lost,
                                        Real threshold = Real(0.05)) noexcept {
  Real square = Real(0);
  for (const Real component : lost.turn) {
    square += component * component;
  }
  const bool moves = lost.curvature * lost.curvature >= threshold * threshold;
  const bool turns = square >= threshold * threshold;
  return moves ? SingularityType::moves_along
               : (turns ? SingularityType::turns : SingularityType::none);
}

/// How a null-space motion is driven: its acceleration is that of a spring and damper whose speed
/// is limited.
template <class Real>
struct NullMotionGains {
  Real kp = Real(100);           ///< 1/s^2
  Real kv = Real(20);            ///< 1/s
  Real largest_speed = Real(1);  ///< rad/s
};

/// kv (clamp(kp / kv distance) - speed).
template <class Real>
constexpr Real driven_acceleration(const NullMotionGains<Real>& gains, Real distance,
                                   Real speed) noexcept {
  const Real wanted = gains.kp / gains.kv * distance;
  const Real limit = gains.largest_speed;
  const Real limited = wanted > limit ? limit : (wanted < -limit ? -limit : wanted);
  return gains.kv * (limited - speed);
}

/// Type 1: the acceleration along n that takes the arm along the lost direction to where the task
/// wants it. Measured from the singularity, the motion s = sigma / curvature has moved the tip by
/// curvature s^2 / 2 along u, so a wanted displacement `error` along u (scaled rows) wants
/// s^2 + 2 error / curvature, on the side `branch`: +1 or -1 as n points. A branch other than the
/// present one drives through the singularity as soon as the wanted place allows; a place out of
/// reach holds the arm at the singularity. `speed` = n^T qd.
template <int rows, class Real>
inline Real drive_along(const NullMotionGains<Real>& gains, const LostDirection<rows, Real>& lost,
                        Real error, Real branch, Real speed) noexcept {
  const Real square = lost.curvature * lost.curvature + Real(1e-6);
  const Real inverse = lost.curvature / square;
  const Real s = lost.sigma * inverse;
  const Real wanted = branch * steps::root(s * s + Real(2) * error * inverse);
  return driven_acceleration(gains, wanted - s, speed);
}

/// Type 2: the acceleration along n that turns the lost direction u away from the wanted motion
/// `error` (scaled rows), at most by a quarter. `urge` is the size of the wanted motion along u
/// from which on it is turned at full speed: a smaller one is not worth it and is let be smoothly.
template <int rows, class Real>
inline Real turn_away(const NullMotionGains<Real>& gains, const Real* u,
                      const LostDirection<rows, Real>& lost, const Real (&error)[rows], Real urge,
                      Real speed) noexcept {
  Real along = Real(0);
  Real across = Real(0);
  Real rate = Real(0);
  Real length = Real(0);
  for (int i = 0; i < rows; ++i) {
    along += u[i] * error[i];
    across += lost.turn[i] * error[i];
    rate += lost.turn[i] * lost.turn[i];
    length += error[i] * error[i];
  }
  const Real size = along < Real(0) ? -along : along;
  const Real share = smooth_step(size / urge);
  const Real sine = along / (steps::root(length) + Real(1e-12));
  const Real turning = steps::root(rate);
  // Down the slope of (u^T error)^2; from its top, where u is along the error, either way.
  const Real way = across * along < Real(0) ? Real(1) : Real(-1);
  const Real far = sine < Real(0) ? -sine : sine;
  return driven_acceleration(gains, share * way * far / (turning + Real(1e-6)), speed);
}

/// The forces, in the rows as given, that bring about `missing` = xdd_cmd - Jd qd - J qdd_0 in all
/// directions of the task except the lost ones, in the sense of `shared_factor`. `Lambda_inv` and
/// `missing` are in the rows as given.
template <int rows, int nv, int size, class Real>
inline void regular_task_force(const SingularDirections<rows, nv, Real>& found,
                               const Real (&scales)[rows], const Real (&Lambda_inv)[size],
                               const Real (&missing)[rows], Real (&F)[rows]) noexcept {
  static_assert(size == rows * rows, "Lambda_inv holds rows x rows numbers");
  const auto U = [&found, &scales](int i, int j) noexcept {
    return found.directions[i * rows + j] / scales[j];
  };
  Real half[size];
  Real x[rows];
  for (int i = 0; i < rows; ++i) {
    Real along = Real(0);
    for (int j = 0; j < rows; ++j) {
      along += U(i, j) * missing[j];
      Real sum = Real(0);
      for (int k = 0; k < rows; ++k) {
        sum += U(i, k) * Lambda_inv[k * rows + j];
      }
      half[i * rows + j] = sum;
    }
    x[i] = along;
  }
  Real turned[size];
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      Real sum = Real(0);
      for (int k = 0; k < rows; ++k) {
        sum += half[i * rows + k] * U(j, k);
      }
      turned[i * rows + j] = sum;
    }
  }
  selective_solve(shared_factor<rows>(turned, found.shares), x);
  for (int j = 0; j < rows; ++j) {
    F[j] = Real(0);
    for (int i = 0; i < rows; ++i) {
      F[j] += U(i, j) * x[i];
    }
  }
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
