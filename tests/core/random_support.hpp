#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/quadratic_program.hpp"

// Random supports for tests of limits, and the same programs in other coordinates: a null space by
// singular values, costs as dense matrices.

namespace treeline::core::tests {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

template <class Sizes, int states = 1>
using Limits = EmittedLimits<double, Sizes, states>;

/// A robot at a state: numbers without a mechanism behind them.
template <class Sizes>
struct Support {
  Matrix M, J_s, J_t;
  Vector tau, f;
  typename Limits<Sizes>::TlSupportLayout layout{};
  typename Limits<Sizes>::TlTorqueLimits limits;
};

inline Matrix random_matrix(Eigen::Index rows, Eigen::Index cols, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  return Matrix::NullaryExpr(rows, cols, [&] { return normal(engine); });
}

/// The first passive velocities are those of a base. Of the held rows the last `copies` repeat the
/// first ones.
template <class Sizes>
Support<Sizes> random_support(int copies, double torque, double bound, std::mt19937& engine) {
  constexpr int V = Sizes::kVelocities, H = Sizes::kHeld;
  Support<Sizes> support;
  const Matrix root = random_matrix(V, V, engine);
  support.M = root * root.transpose() / V + 0.3 * Matrix::Identity(V, V);
  support.J_s = random_matrix(H, V, engine);
  for (int row = 0; row < copies; ++row) {
    support.J_s.row(H - copies + row) = support.J_s.row(row) * (row + 1);
  }
  support.J_t = random_matrix(Sizes::kTask, V, engine);
  support.tau = 3 * random_matrix(V, 1, engine);
  support.f = 3 * random_matrix(H, 1, engine);
  for (int j = 0; j < Sizes::kPassive; ++j) {
    support.layout.passive[j] = j;
    support.tau(j) = 0;
  }
  for (int row = 0; row < H; ++row) support.layout.force_weights[row] = row % 2 == 0 ? 1 : 0.1;
  for (double& each : support.layout.shares) each = 1;
  for (double& each : support.layout.task_weights) each = 1;
  for (double& each : support.limits.torque) each = torque;
  for (double& each : support.limits.task_weights) each = 1;
  for (int c = 0; c < Sizes::kCones; ++c) {
    const Vector row = random_matrix(2, 1, engine);
    support.limits.cones[c] = {c % (H - 1), 2, {row(0), row(1)}, bound};
  }
  return support;
}

template <class Sizes>
struct Outcome {
  Vector tau, f;
  typename Limits<Sizes>::TlLimitedTorque limited;
};

/// Entries of a matrix row by row.
inline std::vector<double> entries_of(const Matrix& matrix) {
  const Matrix columns = matrix.transpose();
  return {columns.data(), columns.data() + columns.size()};
}

template <class Sizes>
Outcome<Sizes> run(const Support<Sizes>& support,
                   const typename Limits<Sizes>::TlLimitedTorque& last = {}) {
  using L = Limits<Sizes>;
  Outcome<Sizes> outcome{support.tau, support.f, last};
  if (L::tl_is_within(&support.layout, &support.limits, outcome.tau.data(), outcome.f.data())) {
    L::tl_report_unlimited(&outcome.limited);
    return outcome;
  }
  L::tl_limit_torque(&support.layout, &support.limits, entries_of(support.M).data(),
                     entries_of(support.J_s).data(), entries_of(support.J_t).data(),
                     outcome.tau.data(), outcome.f.data(), &outcome.limited);
  return outcome;
}

/// w J_s d_qdd + (1 - w) Lambda^-1_ii d_f of held rows, over (d_qdd, d_f).
template <class Sizes>
Matrix held_equations(const Support<Sizes>& support) {
  constexpr int V = Sizes::kVelocities, H = Sizes::kHeld;
  Matrix equations = Matrix::Zero(H, V + H);
  const Matrix M_inverse = support.M.inverse();
  for (int row = 0; row < H; ++row) {
    const double share = support.layout.shares[row];
    const Vector J = support.J_s.row(row);
    equations.row(row).head(V) = share * J.transpose();
    equations(row, V + row) = (1 - share) * J.dot(M_inverse * J);
  }
  return equations;
}

/// All changes (d_qdd, d_f) that keep the equations, as the columns of a matrix.
template <class Sizes>
Matrix null_space(const Support<Sizes>& support) {
  constexpr int V = Sizes::kVelocities, H = Sizes::kHeld, P = Sizes::kPassive;
  Matrix equations = Matrix::Zero(H + P, V + H);
  equations.topRows(H) = held_equations(support);
  equations.bottomLeftCorner(P, V) = support.M.topRows(P);
  equations.bottomRightCorner(P, H) = -support.J_s.leftCols(P).transpose();
  const Eigen::JacobiSVD<Matrix> svd(equations, Eigen::ComputeFullV);
  const auto rank = (svd.singularValues().array() > 1e-9 * svd.singularValues()(0)).count();
  return svd.matrixV().rightCols(V + H - rank);
}

/// The cost of a change as a matrix of (d_qdd, d_f), as the header states it.
template <class Sizes>
Matrix cost_matrix(const Support<Sizes>& support) {
  constexpr int V = Sizes::kVelocities, H = Sizes::kHeld, P = Sizes::kPassive;
  const double k = LimitNumbers<double>::kHierarchy;
  Matrix cost = Matrix::Zero(V + H, V + H);
  cost.topLeftCorner(V, V) = support.M;
  const Matrix M_inverse = support.M.inverse();
  for (int t = 0; t < Sizes::kTask; ++t) {
    const Vector row = support.J_t.row(t);
    const double mobility = row.dot(M_inverse * row);
    cost.topLeftCorner(V, V) += k * k * support.layout.task_weights[t] *
                                support.limits.task_weights[t] / mobility * row * row.transpose();
  }
  // The part of S^-1 d_f that carries nothing.
  const Vector S = Vector::Map(support.layout.force_weights, H);
  const Matrix G = S.asDiagonal() * support.J_s.leftCols(P);
  Matrix carried = Matrix::Zero(H, H);
  if (P > 0) carried = G * G.completeOrthogonalDecomposition().pseudoInverse();
  const Vector inverse = (S.array() > 0).select(S.cwiseInverse(), Vector::Zero(H));
  const Matrix free = (Matrix::Identity(H, H) - carried) * inverse.asDiagonal();
  cost.bottomRightCorner(H, H) =
      free.transpose() * free / (k * k * support.M.diagonal().maxCoeff());
  return cost;
}

/// d_tau of a change.
template <class Sizes>
Matrix torque_matrix(const Support<Sizes>& support) {
  Matrix result(Sizes::kVelocities, Sizes::kVelocities + Sizes::kHeld);
  result << support.M, -support.J_s.transpose();
  return result;
}

/// The change that was made, from torques and forces.
template <class Sizes>
Vector change_of(const Support<Sizes>& support, const Outcome<Sizes>& outcome) {
  Vector change(Sizes::kVelocities + Sizes::kHeld);
  const Vector d_f = outcome.f - support.f;
  change << support.M.ldlt().solve(
      Vector(outcome.tau - support.tau + support.J_s.transpose() * d_f)),
      d_f;
  return change;
}

inline double most_beyond_cones(const auto& support, const Vector& f) {
  double most = 0;
  for (const auto& cone : support.limits.cones) {
    const double share = support.layout.shares[cone.first];
    double value = -cone.bound * share;
    for (int k = 0; k < cone.count; ++k) value += cone.coefficients[k] * f(cone.first + k);
    most = std::max(most, value * std::pow(share, 7));
  }
  return most;
}

/// The program in the coordinates of the null space, with hard cones widened by `slack`.
template <class Sizes>
Vector solve_otherwise(const Support<Sizes>& support, double slack) {
  constexpr int V = Sizes::kVelocities, P = Sizes::kPassive, C = Sizes::kCones;
  constexpr int F = Sizes::kFreedoms, M = V - P + C;
  const Matrix Z = null_space(support);
  EXPECT_EQ(Z.cols(), F);
  const Matrix cost = Z.transpose() * cost_matrix(support) * Z;
  const Matrix torques = torque_matrix(support) * Z;
  double H[F * F];
  const double g[F] = {};
  QuadraticRows<double, F, M> rows;
  for (int i = 0; i < F; ++i) {
    for (int k = 0; k < F; ++k) H[i * F + k] = cost(i, k);
    rows.lowest[i] = -LimitNumbers<double>::kNoLimit;
    rows.highest[i] = LimitNumbers<double>::kNoLimit;
  }
  for (int row = 0; row < M; ++row) {
    Vector a = Vector::Zero(F);
    rows.lower[row] = -LimitNumbers<double>::kNoLimit;
    if (row < V - P) {
      a += torques.row(P + row).transpose();
      rows.lower[row] = -support.limits.torque[P + row] - support.tau(P + row);
      rows.upper[row] = support.limits.torque[P + row] - support.tau(P + row);
    } else {
      const auto& cone = support.limits.cones[row - (V - P)];
      const double share = support.layout.shares[cone.first];
      rows.upper[row] = cone.bound * share + slack;
      if (std::pow(share, 7) <= LimitNumbers<double>::kLeastCone) {
        rows.upper[row] = LimitNumbers<double>::kNoLimit;
      }
      for (int k = 0; k < cone.count; ++k) {
        a += cone.coefficients[k] * Z.row(V + cone.first + k).transpose();
        rows.upper[row] -= cone.coefficients[k] * support.f(cone.first + k);
      }
    }
    for (int k = 0; k < F; ++k) rows.A[row * F + k] = a(k);
  }
  QuadraticSolution<double, F, M> solution = {};
  solve_quadratic_program(H, g, rows, solution);
  EXPECT_EQ(solution.status, QuadraticStatus::solved);
  return Z * Vector::Map(solution.x, F);
}

/// Takes shares, in pairs of held rows and one of each task: 0, 1, and all between.
template <class Sizes>
void take_shares(const std::vector<double>& held, const std::vector<double>& tasks,
                 Support<Sizes>& support) {
  for (int row = 0; row < Sizes::kHeld; ++row) support.layout.share_of[row] = row / 2;
  for (int row = 0; row < Sizes::kTask; ++row) support.layout.share_of_task[row] = row;
  Limits<Sizes>::tl_share_supports(held.data(), &support.layout);
  Limits<Sizes>::tl_share_tasks(tasks.data(), &support.layout);
}

template <class Sizes>
void draw_shares(Support<Sizes>& support, std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto drawn = [&](std::size_t count) {
    std::vector<double> shares(count);
    for (double& each : shares) {
      const double values[] = {0, 1e-5, uniform(engine), uniform(engine), 1 - 1e-9, 1};
      each = values[engine() % 6];
    }
    return shares;
  };
  take_shares(drawn((Sizes::kHeld + 1) / 2), drawn(Sizes::kTask), support);
  for (int row = 0; row < Sizes::kHeld; ++row) support.f(row) *= support.layout.shares[row];
  for (auto& cone : support.limits.cones) cone.first -= cone.first % 2;  // of one constraint
}

/// Sweeps over supports of one kind: how much may be limited, and how.
template <class Sizes>
void sweep(int copies, double torque, double bound, bool shares = false) {
  std::mt19937 engine(static_cast<unsigned>(Sizes::kVelocities * 10 + Sizes::kHeld));
  int limited = 0, slack = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    auto support = random_support<Sizes>(copies, torque, bound, engine);
    if (shares) draw_shares(support, engine);
    const auto outcome = run(support);
    ASSERT_EQ(outcome.limited.status, Limits<Sizes>::TL_SOLVED);
    limited += outcome.limited.limited ? 1 : 0;
    slack += outcome.limited.slack > 0 ? 1 : 0;
    EXPECT_LE(outcome.tau.cwiseAbs().maxCoeff(), torque);
    EXPECT_LE(most_beyond_cones(support, outcome.f), outcome.limited.slack + 1e-9);
    const Vector change = change_of(support, outcome);
    const Vector d_qdd = change.head(Sizes::kVelocities);
    EXPECT_LT((held_equations(support) * change).norm(), 1e-9 * (1 + change.norm()));
    for (int j = 0; j < Sizes::kPassive; ++j) EXPECT_EQ(outcome.tau(j), 0);
    for (int t = 0; t < Sizes::kTask; ++t) {
      const bool done = support.layout.task_weights[t] > 0;
      EXPECT_NEAR(outcome.limited.lost[t], done ? -support.J_t.row(t).dot(d_qdd) : 0, 1e-7);
    }
    if (outcome.limited.slack > 0) continue;
    const Vector other = solve_otherwise(support, 1e-12);
    const Matrix cost = cost_matrix(support);
    // The condition of the cost, 1e12, costs that many digits of its square root.
    const double own_cost = change.dot(cost * change), other_cost = other.dot(cost * other);
    EXPECT_NEAR(own_cost, other_cost, 1e-5 * other_cost + 1e-12);
    const auto again = run(support, outcome.limited);
    EXPECT_LT((again.tau - outcome.tau).norm(), 1e-8 * outcome.tau.norm());
    EXPECT_LT((again.f - outcome.f).norm(), 1e-8 * (1e-3 + outcome.f.norm()));
  }
  std::printf("%d of 200 limited, %d with slack\n", limited, slack);
  EXPECT_GT(limited, 100);
}

}  // namespace treeline::core::tests
