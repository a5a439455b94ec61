#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/algebra/factor_ldlt.hpp"
#include "recursion/algebra/shared_pivots.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {

/// Lever arm at which a moment counts like a force when forces of constraints are chosen, m: about
/// half a foot.
inline constexpr double kForceLever = 0.1;

/// How the rows of a supported control torque are inverted. `held` are those of the constraints.
struct SupportRules {
  PivotRule rows;    ///< of Lambda^-1: constraints, then tasks
  PivotRule locked;  ///< of the constraints, with motors locked
  PivotRule forces;  ///< of the equations for forces on passive joints
  std::size_t held = 0;
  /// Whether passive joints can move while motors and constraints hold still. Then no force of the
  /// constraints can replace each motor that is missing.
  bool passive_moves = false;
};

template <class Scalar>
DenseMatrix<Scalar> columns_of(const DenseMatrix<Scalar>& A, const std::vector<int>& columns) {
  DenseMatrix<Scalar> result(A.rows(), columns.size());
  for (std::size_t i = 0; i < A.rows(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      result(i, j) = A(i, static_cast<std::size_t>(columns[j]));
    }
  }
  return result;
}

/// The block of M that belongs to these velocities: inertia with all other joints locked.
template <class Scalar>
DenseMatrix<Scalar> block_of_velocities(const DenseMatrix<Scalar>& M,
                                        const std::vector<int>& velocities) {
  DenseMatrix<Scalar> block(velocities.size(), velocities.size());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    for (std::size_t j = 0; j < velocities.size(); ++j) {
      block(i, j) =
          M(static_cast<std::size_t>(velocities[i]), static_cast<std::size_t>(velocities[j]));
    }
  }
  return block;
}

/// J K^-1 J^T of a factored K.
template <class Scalar>
DenseMatrix<Scalar> mobility_of_rows(const LdltFactor<Scalar>& K, const DenseMatrix<Scalar>& J) {
  const std::size_t rows = J.rows();
  std::vector<std::vector<Scalar>> carried;
  for (std::size_t i = 0; i < rows; ++i) {
    std::vector<Scalar> row;
    for (std::size_t k = 0; k < J.cols(); ++k) row.push_back(J(i, k));
    carried.push_back(solve_lower(K, row));
  }
  DenseMatrix<Scalar> B(rows, rows);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < J.cols(); ++k) {
      const Scalar scaled = carried[i][k] * K.inverse_D[k];
      for (std::size_t j = 0; j <= i; ++j) B(i, j) = B(i, j) + scaled * carried[j][k];
    }
    for (std::size_t j = 0; j < i; ++j) B(j, i) = B(i, j);
  }
  return B;
}

template <class Scalar>
DenseMatrix<Scalar> leading_block(const DenseMatrix<Scalar>& A, std::size_t size) {
  DenseMatrix<Scalar> block(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) block(i, j) = A(i, j);
  }
  return block;
}

/// Motion of passive joints while motors do not move and the first rows are held:
///     K_s^-1 = K^-1 - K^-1 J_s^T (J_s K^-1 J_s^T)^-1 J_s K^-1,
/// K: the block of M of the passive joints; J: columns of the passive joints, all rows; `shares`:
/// to which rows are held, see `SharedPivots`.
template <class Scalar>
class PassiveMotion {
 public:
  PassiveMotion(const DenseMatrix<Scalar>& K, DenseMatrix<Scalar> J, const SupportRules& rules,
                const std::vector<Scalar>& shares)
      : J_(std::move(J)),
        K_(factor_ldlt(K)),
        B_(mobility_of_rows(K_, J_)),
        held_(factor_shared(leading_block(B_, rules.held), rules.locked, shares)) {}

  /// K_s^-1 x.
  [[nodiscard]] std::vector<Scalar> solve_for(const std::vector<Scalar>& x) const {
    std::vector<Scalar> y = solve(K_, x);
    const std::size_t held = held_.inverse_D.size();
    std::vector<Scalar> rates(held, Scalar(0.0));
    for (std::size_t i = 0; i < held; ++i) {
      for (std::size_t k = 0; k < J_.cols(); ++k) rates[i] = rates[i] + J_(i, k) * y[k];
    }
    const std::vector<Scalar> f = solve(held_, rates);
    std::vector<Scalar> reaction(J_.cols(), Scalar(0.0));
    for (std::size_t i = 0; i < held; ++i) {
      for (std::size_t k = 0; k < J_.cols(); ++k) reaction[k] = reaction[k] + J_(i, k) * f[i];
    }
    const std::vector<Scalar> back = solve(K_, reaction);
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = y[k] - back[k];
    return y;
  }

  /// Subtracts from Lambda^-1, in the rows that are not held, what passive joints alone can move:
  /// J_t K_s^-1 J_t^T.
  void subtract_from(DenseMatrix<Scalar>& Lambda_inv) const {
    const std::size_t held = held_.inverse_D.size();
    const std::size_t rows = B_.rows();
    std::vector<std::vector<Scalar>> carried(rows);
    for (std::size_t i = held; i < rows; ++i) {
      std::vector<Scalar> column;
      for (std::size_t k = 0; k < held; ++k) column.push_back(B_(k, i));
      carried[i] = solve_lower(held_, column);
    }
    for (std::size_t i = held; i < rows; ++i) {
      for (std::size_t j = held; j <= i; ++j) {
        Scalar left = B_(i, j);
        for (std::size_t k = 0; k < held; ++k) {
          left = left - carried[i][k] * held_.inverse_D[k] * carried[j][k];
        }
        Lambda_inv(i, j) = Lambda_inv(i, j) - left;
        Lambda_inv(j, i) = Lambda_inv(i, j);
      }
    }
  }

 private:
  DenseMatrix<Scalar> J_;
  LdltFactor<Scalar> K_;
  DenseMatrix<Scalar> B_;
  LdltFactor<Scalar> held_;
};

/// Weight of each row when forces are chosen: 1, or the lever squared for a moment.
template <class Scalar>
std::vector<Scalar> force_weights(const std::vector<TreePoint<Scalar>>& points) {
  std::vector<Scalar> weights;
  for (const TreePoint<Scalar>& point : points) {
    for (std::size_t k = 0; k < 6; ++k) {
      if (point.rows[k]) weights.emplace_back(k < 3 ? 1.0 : kForceLever * kForceLever);
    }
  }
  return weights;
}

/// Weights of the rows that are held: of the first `anchored` rows of the points, then of the
/// loops. A coupling's row counts like a force.
template <class Scalar>
std::vector<Scalar> held_weights(const Tree<Scalar>& tree, std::size_t anchored) {
  std::vector<Scalar> weights = force_weights(tree.operational_points);
  weights.resize(anchored);
  for (const TreeLoop<Scalar>& loop : tree.loops) {
    const auto own = force_weights<Scalar>({loop.second});
    weights.insert(weights.end(), own.begin(), own.end());
  }
  weights.resize(weights.size() + tree.couplings.size(), Scalar(1.0));
  return weights;
}

/// J^T W J of the first rows of J.
template <class Scalar>
DenseMatrix<Scalar> weighted_square(const DenseMatrix<Scalar>& J,
                                    const std::vector<Scalar>& weights, std::size_t rows) {
  DenseMatrix<Scalar> D(J.cols(), J.cols());
  for (std::size_t i = 0; i < D.rows(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k < rows; ++k) {
        D(i, j) = D(i, j) + J(k, i) * weights[k] * J(k, j);
      }
      D(j, i) = D(i, j);
    }
  }
  return D;
}

}  // namespace treeline
