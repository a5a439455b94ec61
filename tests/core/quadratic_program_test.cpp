// Quadratic programs of fixed size compared with CGAL's solver in exact rational numbers, and with
// the conditions of Karush, Kuhn and Tucker in 50 digits. Would catch: a wrong minimum or
// multiplier, a row that is missed, a cycle on degenerate rows, a row set aside that conflicts with
// nothing or a conflict that is overlooked, a start that changes the answer, a dependence on units,
// a NaN, and more iterations or operations than stated.
#include "core/quadratic_program.hpp"

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "quadratic_cases.hpp"

namespace {

using namespace treeline::test;  // NOLINT: the cases
using treeline::core::QuadraticStatus;
using treeline::core::RowSide;
using Digits50 = boost::multiprecision::cpp_dec_float_50;

/// The exact minimum by CGAL over the rows that are not set aside; nothing where there is none.
template <int N, int M>
std::optional<std::vector<double>> exact_minimum(const Case<double, N, M>& problem,
                                                 const QuadraticSolution<double, N, M>& solution) {
  using Number = CGAL::Gmpzf;
  CGAL::Quadratic_program<Number> program(CGAL::SMALLER, false, 0, false, 0);
  for (int i = 0; i < N; ++i) {
    program.set_c(i, problem.g[i]);
    const bool counts = solution.sides[i] != RowSide::set_aside;
    const double lower = problem.rows.lowest[i];
    const double upper = problem.rows.highest[i];
    program.set_l(i, counts && std::isfinite(lower), std::isfinite(lower) ? lower : 0);
    program.set_u(i, counts && std::isfinite(upper), std::isfinite(upper) ? upper : 0);
    for (int k = 0; k <= i; ++k) program.set_d(i, k, problem.H[i * N + k]);
  }
  int rows = 0;
  const auto add = [&](int i, double bound, CGAL::Comparison_result relation) {
    for (int k = 0; k < N; ++k) program.set_a(k, rows, problem.rows.A[i * N + k]);
    program.set_r(rows, relation);
    program.set_b(rows, bound);
    ++rows;
  };
  for (int i = 0; i < M; ++i) {
    if (solution.sides[N + i] == RowSide::set_aside) continue;
    if (std::isfinite(problem.rows.lower[i])) add(i, problem.rows.lower[i], CGAL::LARGER);
    if (std::isfinite(problem.rows.upper[i])) add(i, problem.rows.upper[i], CGAL::SMALLER);
  }
  auto exact = CGAL::solve_quadratic_program(program, Number());
  // CGAL's own certificate: it calls some infeasible programs optimal.
  if (!exact.is_optimal() || !exact.solves_quadratic_program(program)) return std::nullopt;
  std::vector<double> x;
  for (auto at = exact.variable_values_begin(); at != exact.variable_values_end(); ++at) {
    x.push_back(CGAL::to_double(*at));
  }
  return x;
}

/// |x - other| in the metric of H, over |x| in it.
template <int N, int M>
double distance(const Case<double, N, M>& problem, const double* x, const double* other) {
  double difference = 0, size = 0;
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < N; ++k) {
      const double entry = problem.H[std::max(i, k) * N + std::min(i, k)];
      difference += (x[i] - other[i]) * entry * (x[k] - other[k]);
      size += x[i] * entry * x[k];
    }
  }
  return std::sqrt(std::max(0.0, difference) / size);
}

/// Residuals of the conditions in 50 digits, relative to the terms of each equation.
struct Residuals {
  double gradient = 0, rows = 0, complementarity = 0;
};

template <int N, int M>
Residuals residuals_of(const Case<double, N, M>& problem,
                       const QuadraticSolution<double, N, M>& solution) {
  Residuals residuals;
  const auto raise = [](double& most, const Digits50& miss, const Digits50& terms) {
    if (miss > 0) most = std::max(most, static_cast<double>(miss / terms));
  };
  for (int i = 0; i < N; ++i) {
    Digits50 sum = Digits50(problem.g[i]) - solution.multipliers[i];
    Digits50 terms = abs(Digits50(problem.g[i])) + std::abs(solution.multipliers[i]);
    const auto include = [&](const Digits50& term) {
      sum += term;
      terms += abs(term);
    };
    for (int k = 0; k < N; ++k) {
      include(Digits50(problem.H[std::max(i, k) * N + std::min(i, k)]) * solution.x[k]);
    }
    for (int row = 0; row < M; ++row) {
      include(-Digits50(problem.rows.A[row * N + i]) * solution.multipliers[N + row]);
    }
    raise(residuals.gradient, abs(sum), terms);
  }
  for (int row = 0; row < N + M; ++row) {
    if (solution.sides[row] == RowSide::set_aside) continue;
    const double lower = row < N ? problem.rows.lowest[row] : problem.rows.lower[row - N];
    const double upper = row < N ? problem.rows.highest[row] : problem.rows.upper[row - N];
    Digits50 value = 0, terms = 0;
    for (int k = 0; k < N; ++k) {
      const double entry = row < N ? (k == row ? 1 : 0) : problem.rows.A[(row - N) * N + k];
      value += Digits50(entry) * solution.x[k];
      terms += abs(Digits50(entry) * solution.x[k]);
    }
    if (std::isfinite(lower)) raise(residuals.rows, lower - value, terms + std::abs(lower));
    if (std::isfinite(upper)) raise(residuals.rows, value - upper, terms + std::abs(upper));
    const double multiplier = solution.multipliers[row];
    if (multiplier == 0) continue;
    EXPECT_TRUE(lower == upper || (multiplier > 0) == (solution.sides[row] == RowSide::lower));
    const double bound = solution.sides[row] == RowSide::upper ? upper : lower;
    raise(residuals.complementarity, abs(value - bound), terms + std::abs(bound));
  }
  return residuals;
}

/// CGAL takes seconds for large programs.
template <int N, int M>
void sweep(int count, std::span<const Kind> kinds = kKinds) {
  std::mt19937 engine(N * 100 + M);
  double worst = 0;
  for (const Kind& kind : kinds) {
    if (kind.conflicting && M < 3) continue;
    for (int i = 0; i < count; ++i) {
      SCOPED_TRACE(::testing::Message() << N << " x " << M << ", " << kind.name << ", " << i);
      const auto problem = random_case<N, M>(kind, engine);
      const auto solution = solve(problem);
      ASSERT_EQ(solution.status,
                kind.conflicting ? QuadraticStatus::conflicting : QuadraticStatus::solved);
      EXPECT_LE(solution.iterations, treeline::core::most_iterations(N, M));
      const auto exact = exact_minimum(problem, solution);
      ASSERT_TRUE(exact.has_value());
      // Rounding of the problem's condition, up to 1e4 here, and of degenerate rows.
      const double off = distance(problem, solution.x, exact->data());
      EXPECT_LT(off, 1e-9);
      worst = std::max(worst, off);
      const Residuals residuals = residuals_of(problem, solution);
      EXPECT_LT(residuals.gradient, 1e-11);
      EXPECT_LT(residuals.rows, 1e-12);
      EXPECT_LT(residuals.complementarity, 1e-12);
      EXPECT_EQ(solution.conflicting_row >= 0, kind.conflicting);
    }
  }
  std::printf("%d x %d: at most %.1e from the exact minimum\n", N, M, worst);
}

TEST(QuadraticProgram, SmallProgramsHaveTheExactMinimum) {
  sweep<1, 1>(100);
  sweep<2, 4>(100);
  sweep<5, 12>(50);
  sweep<9, 7>(50);
}

TEST(QuadraticProgram, LargeProgramsHaveTheExactMinimum) {
  sweep<20, 30>(2);
  sweep<40, 60>(1, std::span(kKinds).last(1));
}

/// A box and its corner: by hand.
TEST(QuadraticProgram, BoundsAndMultipliersByHand) {
  Case<double, 2, 1> problem;
  problem.H[0] = problem.H[3] = 2;
  problem.g[0] = -4;
  problem.g[1] = -6;  // minimum (2, 3)
  problem.rows = {{-kNone, -kNone}, {1, kNone}, {1, 1}, {-kNone}, {3}};
  const auto solution = solve(problem);
  EXPECT_EQ(solution.status, QuadraticStatus::solved);
  EXPECT_DOUBLE_EQ(solution.x[0], 1);
  EXPECT_DOUBLE_EQ(solution.x[1], 2);
  EXPECT_DOUBLE_EQ(solution.multipliers[0], 0);
  EXPECT_DOUBLE_EQ(solution.multipliers[2], -2);
  EXPECT_EQ(solution.sides[2], RowSide::upper);
}

TEST(QuadraticProgram, OfTwoRowsInConflictTheLessViolatedIsSetAside) {
  Case<double, 1, 2> problem;
  problem.H[0] = 1;
  problem.rows = {{-kNone}, {kNone}, {1, 1}, {2, -kNone}, {kNone, 1}};  // x >= 2 and x <= 1
  const auto solution = solve(problem);
  EXPECT_EQ(solution.status, QuadraticStatus::conflicting);
  EXPECT_EQ(solution.conflicting_row, 2);
  EXPECT_EQ(solution.sides[2], RowSide::set_aside);
  EXPECT_DOUBLE_EQ(solution.x[0], 2);
}

TEST(QuadraticProgram, TheLastActiveSetIsAStartWithTheSameAnswer) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  long cold = 0, warm = 0;
  for (int i = 0; i < 200; ++i) {
    auto problem = random_case<12, 20>(kKinds[i % 5], engine);
    auto solution = solve(problem);
    auto again = solution;
    treeline::core::solve_quadratic_program(problem.H, problem.g, problem.rows, again);
    EXPECT_LT(distance(problem, again.x, solution.x), 1e-12);
    EXPECT_EQ(again.iterations, 0);
    for (double& each : problem.g) each += 0.01 * normal(engine);
    const auto next = solve(problem);
    treeline::core::solve_quadratic_program(problem.H, problem.g, problem.rows, solution);
    EXPECT_LT(distance(problem, next.x, solution.x), 1e-12);
    cold += next.iterations;
    warm += solution.iterations;
    // Any start will do, however wrong.
    for (RowSide& side : again.sides) {
      side = static_cast<RowSide>(static_cast<int>(engine() % 3) - 1);
    }
    treeline::core::solve_quadratic_program(problem.H, problem.g, problem.rows, again);
    EXPECT_EQ(again.status, QuadraticStatus::solved);
    EXPECT_LT(distance(problem, next.x, again.x), 1e-12);
  }
  EXPECT_LT(5 * warm, cold);
}

TEST(QuadraticProgram, SinglePrecisionIsNearDouble) {
  std::mt19937 engine(4);
  for (int i = 0; i < 200; ++i) {
    const auto problem = random_case<12, 20>(kKinds[i % 5], engine);
    Case<float, 12, 20> rounded;
    const auto copy = [](const auto& from, auto& to) {
      std::transform(std::begin(from), std::end(from), std::begin(to),
                     [](double each) { return static_cast<float>(each); });
    };
    copy(problem.H, rounded.H);
    copy(problem.g, rounded.g);
    copy(problem.rows.lowest, rounded.rows.lowest);
    copy(problem.rows.highest, rounded.rows.highest);
    copy(problem.rows.A, rounded.rows.A);
    copy(problem.rows.lower, rounded.rows.lower);
    copy(problem.rows.upper, rounded.rows.upper);
    const auto single = solve(rounded);
    ASSERT_EQ(single.status, QuadraticStatus::solved);
    const std::vector<double> x(single.x, single.x + 12);
    EXPECT_LT(distance(problem, solve(problem).x, x.data()), 2e-3);
  }
}

TEST(QuadraticProgram, WithoutAMinimumTheAnswerIsZero) {
  Case<double, 3, 1> problem;
  problem.rows = {{-1, -1, -1}, {1, 1, 1}, {1, 1, 1}, {-kNone}, {1}};
  problem.H[0] = problem.H[4] = 1;  // a flat direction
  problem.g[2] = 1;
  auto solution = solve(problem);
  EXPECT_EQ(solution.status, QuadraticStatus::not_convex);
  EXPECT_EQ(solution.x[2], 0);
  problem.H[8] = -1;
  solution = solve(problem);
  EXPECT_EQ(solution.status, QuadraticStatus::not_convex);
}

TEST(QuadraticProgram, NoFiniteInputGivesNaN) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> decades(-300, 300);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 3000; ++i) {
    auto problem = random_case<5, 12>(kKinds[i % 8], engine);
    const auto spoil = [&](auto& numbers) {
      for (double& each : numbers) {
        if (engine() % 20 == 0) each = normal(engine) * std::pow(10.0, decades(engine));
        if (engine() % 20 == 0) each = 0;
      }
    };
    spoil(problem.g);
    spoil(problem.rows.A);
    spoil(problem.rows.lower);
    spoil(problem.rows.upper);
    if (i % 2 == 0) spoil(problem.H);
    const auto solution = solve(problem);
    for (const double each : solution.x) EXPECT_TRUE(std::isfinite(each)) << i;
    for (const double each : solution.multipliers) EXPECT_TRUE(std::isfinite(each)) << i;
    EXPECT_LE(solution.iterations, 2 * treeline::core::most_iterations(5, 12));
  }
}

// A row that is NaN is violated by no x: no comparison finds it. It is not solved all the same.
TEST(QuadraticProgram, SaysThatNaNHasNoAnswer) {
  std::mt19937 engine(9);
  const auto expect_none = [&](const auto& choose) {
    for (int i = 0; i < 40; ++i) {
      auto problem = random_case<5, 12>(kKinds[i % 8], engine);
      auto& numbers = choose(problem);
      numbers[engine() % std::size(numbers)] = std::numeric_limits<double>::quiet_NaN();
      const auto solution = solve(problem);
      EXPECT_EQ(solution.status, QuadraticStatus::not_convex) << i;
      for (const double each : solution.x) EXPECT_EQ(each, 0);
    }
  };
  expect_none([](auto& problem) -> auto& { return problem.g; });
  expect_none([](auto& problem) -> auto& { return problem.rows.A; });
  expect_none([](auto& problem) -> auto& { return problem.rows.lower; });
  expect_none([](auto& problem) -> auto& { return problem.rows.upper; });
  expect_none([](auto& problem) -> auto& { return problem.rows.lowest; });
  expect_none([](auto& problem) -> auto& { return problem.rows.highest; });
}

TEST(QuadraticProgram, UsedUpIterationsLeaveTheMinimumOverTheActiveRows) {
  std::mt19937 engine(6);
  const auto problem = random_case<12, 20>(kKinds[0], engine);
  const int needed = solve(problem).iterations;
  ASSERT_GT(needed, 3);
  for (int most = 0; most < needed; ++most) {
    QuadraticSolution<double, 12, 20> solution = {};
    treeline::core::solve_quadratic_program(problem.H, problem.g, problem.rows, solution, most);
    EXPECT_EQ(solution.status, QuadraticStatus::limit);
    EXPECT_LT(residuals_of(problem, solution).gradient, 1e-12);
    EXPECT_LT(residuals_of(problem, solution).complementarity, 1e-12);
  }
}

TEST(QuadraticProgram, TheNearestPointIsThatOfTheUnitMatrix) {
  std::mt19937 engine(7);
  for (int i = 0; i < 100; ++i) {
    auto problem = random_case<9, 14>(kKinds[i % 5], engine);
    double center[9];
    for (int k = 0; k < 9; ++k) {
      center[k] = -problem.g[k];
      for (int j = 0; j < 9; ++j) problem.H[k * 9 + j] = k == j ? 1 : 0;
    }
    QuadraticSolution<double, 9, 14> nearest = {};
    treeline::core::solve_least_distance(center, problem.rows, nearest);
    const auto solution = solve(problem);
    for (int k = 0; k < 9; ++k) EXPECT_DOUBLE_EQ(nearest.x[k], solution.x[k]);
  }
}

}  // namespace
