#pragma once

#include <vector>

#include "recursion/methods/factor_mass_matrix.hpp"
#include "recursion/methods/inverse_dynamics_derivatives.hpp"

namespace treeline {

/// Derivatives of accelerations with respect to displacements, velocities and joint forces, nv x
/// nv.
template <class Scalar>
struct AccelerationDerivatives {
  DenseMatrix<Scalar> dq, dqd, dtau;
};

/// M^-1 = L^-1 D^-1 L^-T, symmetric. L^-1 has zeros where M has.
template <class Scalar>
DenseMatrix<Scalar> inverse(const LtdlFactor<Scalar>& factor) {
  const std::size_t n = factor.inverse_D.size();
  DenseMatrix<Scalar> W(n, n);  // L^-1
  for (std::size_t j = 0; j < n; ++j) {
    W(j, j) = Scalar(1.0);
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = j; k < i; ++k) {
        W(i, j) = W(i, j) - factor.L(i, k) * W(k, j);
      }
    }
  }
  DenseMatrix<Scalar> result(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        result(i, j) = result(i, j) + W(i, k) * factor.inverse_D[k] * W(j, k);
      }
      result(j, i) = result(i, j);
    }
  }
  return result;
}

/// Assigns lanes to row `i` of B, one per column. A common sign of all entries is taken out.
template <class Scalar>
void align_row(DenseMatrix<Scalar>& B, std::size_t i) {
  if constexpr (std::is_same_v<Scalar, Expression>) {
    bool negative = true;
    for (std::size_t j = 0; j < B.cols(); ++j) {
      negative = negative && (B(i, j).is_constant() || B(i, j).negative());
    }
    std::vector<Scalar> lanes;
    for (std::size_t j = 0; j < B.cols(); ++j) {
      lanes.push_back(negative ? -B(i, j) : B(i, j));
    }
    align_lanes(lanes);
    for (std::size_t j = 0; j < B.cols(); ++j) {
      B(i, j) = negative ? -lanes[j] : lanes[j];
    }
  }
}

/// M^-1 B, all columns together.
template <class Scalar>
DenseMatrix<Scalar> solve_columns(const LtdlFactor<Scalar>& factor, DenseMatrix<Scalar> B) {
  const std::size_t n = B.rows();
  const auto subtract = [&B](std::size_t to, const Scalar& factor_of, std::size_t from) {
    for (std::size_t j = 0; j < B.cols(); ++j) {
      B(to, j) = B(to, j) - factor_of * B(from, j);
    }
  };
  for (std::size_t k = n; k-- > 0;) {
    align_row(B, k);
    for (std::size_t i = 0; i < k; ++i) {
      subtract(i, factor.L(k, i), k);
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < B.cols(); ++j) {
      B(k, j) = B(k, j) * factor.inverse_D[k];
    }
    for (std::size_t i = 0; i < k; ++i) {
      subtract(k, factor.L(k, i), i);
    }
    align_row(B, k);
  }
  return B;
}

template <class Scalar>
DenseMatrix<Scalar> product(const DenseMatrix<Scalar>& A, const DenseMatrix<Scalar>& B) {
  DenseMatrix<Scalar> C(A.rows(), B.cols());
  for (std::size_t i = 0; i < A.rows(); ++i) {
    for (std::size_t j = 0; j < B.cols(); ++j) {
      for (std::size_t k = 0; k < A.cols(); ++k) {
        C(i, j) = C(i, j) + A(i, k) * B(k, j);
      }
    }
  }
  return C;
}

template <class Scalar>
DenseMatrix<Scalar> operator-(DenseMatrix<Scalar> A) {
  for (std::size_t i = 0; i < A.rows(); ++i) {
    for (std::size_t j = 0; j < A.cols(); ++j) {
      A(i, j) = -A(i, j);
    }
  }
  return A;
}

/// Ways to form dqdd/dq = -M^-1 dtau/dq: by a solve, or with the inverse, which is a result anyway.
enum class DerivativeRoute { solve, multiply };

/// The factors of M, and the accelerations that result from tau.
template <class Scalar>
struct SolvedMotion {
  LtdlFactor<Scalar> factor;
  std::vector<Scalar> qdd;
};

template <class Scalar>
SolvedMotion<Scalar> solve_motion(const Tree<Scalar>& tree,
                                  const std::vector<JointTransform<Scalar>>& X,
                                  const std::vector<Scalar>& qd, const std::vector<Scalar>& tau,
                                  std::span<const Scalar> f_ext) {
  SolvedMotion<Scalar> motion{factor_ltdl(mass_matrix(tree, X)), {}};
  const std::vector<Wrench<Scalar>> applied =
      f_ext.empty() ? std::vector<Wrench<Scalar>>{} : applied_wrenches<Scalar>(tree, X, f_ext);
  const auto h = inverse_dynamics<Scalar>(tree, X, {qd, {}}, applied);
  std::vector<Scalar> net = tau;
  for (std::size_t i = 0; i < net.size(); ++i) {
    net[i] = net[i] - h[i];
  }
  motion.qdd = solve(motion.factor, net);
  return motion;
}

/// Derivatives of forward dynamics: -M^-1 times those of inverse dynamics at the qdd that results
/// from tau.
template <class Scalar>
AccelerationDerivatives<Scalar> forward_dynamics_derivatives(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
    const std::vector<Scalar>& qd, const std::vector<Scalar>& tau, std::span<const Scalar> f_ext,
    DerivativeRoute route) {
  const auto [factor, qdd] = solve_motion(tree, X, qd, tau, f_ext);
  const auto forces = inverse_dynamics_derivatives<Scalar>(tree, X, {qd, qdd}, f_ext);
  const DenseMatrix<Scalar> M_inverse = inverse(factor);
  const auto solved = [&, &factor = factor](const DenseMatrix<Scalar>& B) {
    return -(route == DerivativeRoute::solve ? solve_columns(factor, B) : product(M_inverse, B));
  };
  return {solved(forces.dq), solved(forces.dqd), M_inverse};
}

}  // namespace treeline
