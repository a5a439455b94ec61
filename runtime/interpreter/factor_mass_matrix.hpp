#pragma once

#include <vector>

#include "interpreter/jacobian.hpp"
#include "interpreter/mass_matrix.hpp"

namespace treeline::interpreter {

namespace detail {

/// Velocity before each velocity on the path to the root, or -1 (RBDA section 6.5). Mimic joints
/// couple coordinates across branches; every velocity then counts as beyond the one before.
template <class Scalar>
std::vector<int> velocity_parents(const Model<Scalar>& model) {
  std::vector<int> parents(static_cast<std::size_t>(model.nv));
  if (model.has_mimics()) {
    for (int v = 0; v < model.nv; ++v) parents[static_cast<std::size_t>(v)] = v - 1;
    return parents;
  }
  PerBody<int> last(model.size(), -1);  // last velocity that moves the body
  for (int i = 0; i < model.size(); ++i) {
    last[i] = last[model.body(i).parent];
    for (int d = 0; d < velocity_count(model.body(i).kind); ++d) {
      const int v = model.body(i).v + d;
      parents[static_cast<std::size_t>(v)] = last[i];
      last[i] = v;
    }
  }
  return parents;
}

}  // namespace detail

/// Factorization M = L^T D L, with L unit lower triangular and as sparse as the tree permits.
template <class Scalar>
struct SparseFactors {
  Matrix<Scalar> LD;         ///< L below the diagonal, D on it
  std::vector<int> parents;  ///< by velocity
};

/// Factors M in place, from the last velocity to the first and only along paths to the root, so
/// that zeros are never touched (RBDA table 6.3).
template <class Scalar>
SparseFactors<Scalar> factor_mass_matrix(const Model<Scalar>& model, VectorArg<Scalar> q) {
  SparseFactors<Scalar> f{mass_matrix<Scalar>(model, q), detail::velocity_parents(model)};
  const auto parent = [&f](int v) { return f.parents[static_cast<std::size_t>(v)]; };
  for (int k = model.nv - 1; k >= 0; --k) {
    for (int i = parent(k); i >= 0; i = parent(i)) {
      const Scalar ratio = f.LD(k, i) / f.LD(k, k);
      for (int j = i; j >= 0; j = parent(j)) f.LD(i, j) -= ratio * f.LD(k, j);
      f.LD(k, i) = ratio;
    }
  }
  return f;
}

/// Lambda^-1 = Y D^-1 Y^T with Y = J L^-1 by back-substitution along the paths (Featherstone,
/// "Exploiting sparsity in operational-space dynamics", IJRR 2010). Also valid with mimic joints.
template <class Scalar>
Matrix<Scalar> lambda_inverse_by_sparse_factors(const Model<Scalar>& model,
                                                PointsArg<Scalar> points, VectorArg<Scalar> q) {
  const SparseFactors<Scalar> f = factor_mass_matrix<Scalar>(model, q);
  Matrix<Scalar> Y = jacobian<Scalar>(model, points, q);
  for (int k = model.nv - 1; k >= 0; --k) {
    for (int i = f.parents[static_cast<std::size_t>(k)]; i >= 0;
         i = f.parents[static_cast<std::size_t>(i)]) {
      Y.col(i) -= f.LD(k, i) * Y.col(k);
    }
  }
  const Vector<Scalar> D_inverse = f.LD.diagonal().cwiseInverse();
  return Y * D_inverse.asDiagonal() * Y.transpose();
}

}  // namespace treeline::interpreter
