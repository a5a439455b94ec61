#pragma once
// Random quadratic programs of several kinds, for tests.
#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "core/quadratic_program.hpp"

namespace treeline::test {

using core::QuadraticRows;
using core::QuadraticSolution;

inline constexpr double kNone = std::numeric_limits<double>::infinity();

template <class Real, int N, int M>
struct Case {
  Real H[N * N] = {};
  Real g[N] = {};
  QuadraticRows<Real, N, M> rows = {};
};

template <class Real, int N, int M>
QuadraticSolution<Real, N, M> solve(const Case<Real, N, M>& problem) {
  QuadraticSolution<Real, N, M> solution = {};
  treeline::core::solve_quadratic_program(problem.H, problem.g, problem.rows, solution);
  return solution;
}

/// What a random program has beside rows in general position.
struct Kind {
  const char* name;
  bool equations = false, copies = false, through_one_point = false, conflicting = false;
  double decades = 0;  ///< of the units of rows and variables
};

/// Rows around a point that obeys them; few of them hold at the minimum without rows.
template <int N, int M>
Case<double, N, M> random_case(const Kind& kind, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(0, 1);
  // Few bits, and units that are powers of two: rows through a point meet there exactly.
  const auto few_bits = [](double number) { return std::ldexp(std::round(number * 1024), -10); };
  const auto unit = [&] {
    return std::exp2(std::round(kind.decades * std::log2(10) * (2 * share(engine) - 1)));
  };
  using Matrix = Eigen::Matrix<double, N, N, Eigen::RowMajor>;
  Matrix root = Matrix::NullaryExpr([&] { return normal(engine); });
  Eigen::Matrix<double, N, 1> units, inside;
  for (int i = 0; i < N; ++i) {
    units(i) = unit();
    inside(i) = few_bits(normal(engine));
  }
  Case<double, N, M> problem;
  Matrix::Map(problem.H) = units.asDiagonal() *
                           (root * root.transpose() / N + 0.1 * Matrix::Identity()) *
                           units.asDiagonal();
  for (int i = 0; i < N; ++i) {
    problem.g[i] = 3 * normal(engine) * units(i);
    const bool bounded = share(engine) < 0.5;
    problem.rows.lowest[i] = bounded ? (inside(i) - few_bits(share(engine))) / units(i) : -kNone;
    problem.rows.highest[i] = bounded ? (inside(i) + few_bits(share(engine))) / units(i) : kNone;
  }
  for (int i = 0; i < M; ++i) {
    double* const a = problem.rows.A + i * N;
    const double scale = unit();
    double value = 0;
    for (int k = 0; k < N; ++k) {
      a[k] = scale * few_bits(normal(engine)) * units(k);
      value += a[k] * (inside(k) / units(k));
    }
    const double room = kind.through_one_point && i % 2 == 0 ? 0 : scale * few_bits(share(engine));
    problem.rows.lower[i] = i % 3 == 0 ? -kNone : value - room;
    problem.rows.upper[i] = i % 3 == 1 ? kNone : value + room;
    if (kind.equations && i < N / 3) {
      problem.rows.lower[i] = value;
      problem.rows.upper[i] = value;
    }
    if (kind.copies && i > 0 && i % 2 == 0) {
      for (int k = 0; k < N; ++k) a[k] = -2 * problem.rows.A[(i - 1) * N + k];
      problem.rows.lower[i] = -2 * problem.rows.upper[i - 1];
      problem.rows.upper[i] = -2 * problem.rows.lower[i - 1];
    }
    if constexpr (M > 2) {
      if (!kind.conflicting || i < M - 1) continue;
      // a_0 x <= b_0, a_1 x <= b_1, (a_0 + a_1) x > b_0 + b_1
      for (int k = 0; k < N; ++k) a[k] = problem.rows.A[k] + problem.rows.A[N + k];
      if (problem.rows.upper[1] == kNone) problem.rows.upper[1] = problem.rows.lower[1] + 1;
      problem.rows.lower[i] = problem.rows.upper[0] + problem.rows.upper[1] + 10 * scale;
      problem.rows.upper[i] = kNone;
    }
  }
  return problem;
}

inline constexpr Kind kKinds[] = {{"general"},
                                  {"equations", true},
                                  {"copies", false, true},
                                  {"through one point", false, false, true},
                                  {"all of these", true, true, true},
                                  {"conflicting", false, false, false, true},
                                  {"in other units", false, false, false, false, 6},
                                  {"degenerate in other units", true, true, true, false, 6}};

}  // namespace treeline::test
