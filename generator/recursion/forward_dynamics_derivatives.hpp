#pragma once

#include <vector>

#include "recursion/factor_mass_matrix.hpp"
#include "recursion/inverse_dynamics_derivatives.hpp"

namespace treeline {

/// Derivatives of accelerations, nv x nv: by displacements, velocities and joint forces.
template <class Scalar>
struct AccelerationDerivatives {
  DenseMatrix<Scalar> dq, dqd, dtau;
};

/// M^-1 = L^-1 D^-1 L^-T, symmetric; L^-1 has zeros where M has.
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

/// M^-1 B, one column after the other.
template <class Scalar>
DenseMatrix<Scalar> solve_columns(const LtdlFactor<Scalar>& factor, DenseMatrix<Scalar> B) {
  for (std::size_t j = 0; j < B.cols(); ++j) {
    std::vector<Scalar> column;
    for (std::size_t i = 0; i < B.rows(); ++i) {
      column.push_back(B(i, j));
    }
    column = solve(factor, std::move(column));
    for (std::size_t i = 0; i < B.rows(); ++i) {
      B(i, j) = column[i];
    }
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

/// How dqdd/dq = -M^-1 dtau/dq is formed: by solving, or with the inverse that is a result anyway.
enum class DerivativeRoute { solve, multiply };

/// Derivatives of forward dynamics: those of inverse dynamics at the qdd that comes of tau, times
/// -M^-1.
template <class Scalar>
AccelerationDerivatives<Scalar> forward_dynamics_derivatives(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
    const std::vector<Scalar>& qd, const std::vector<Scalar>& tau, std::span<const Scalar> f_ext,
    DerivativeRoute route) {
  const LtdlFactor<Scalar> factor = factor_ltdl(mass_matrix(tree, X));
  const std::vector<Wrench<Scalar>> applied =
      f_ext.empty() ? std::vector<Wrench<Scalar>>{} : applied_wrenches<Scalar>(tree, X, f_ext);
  const auto h = inverse_dynamics<Scalar>(tree, X, {qd, {}}, applied);
  std::vector<Scalar> net = tau;
  for (std::size_t i = 0; i < net.size(); ++i) {
    net[i] = net[i] - h[i];
  }
  const std::vector<Scalar> qdd = solve(factor, net);
  const auto forces = inverse_dynamics_derivatives<Scalar>(tree, X, {qd, qdd}, f_ext);
  const DenseMatrix<Scalar> M_inverse = inverse(factor);
  const auto solved = [&](const DenseMatrix<Scalar>& B) {
    return -(route == DerivativeRoute::solve ? solve_columns(factor, B) : product(M_inverse, B));
  };
  return {solved(forces.dq), solved(forces.dqd), M_inverse};
}

}  // namespace treeline
