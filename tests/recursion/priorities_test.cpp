#include <gtest/gtest.h>

#include <iostream>

#include "core/prioritized_solve.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/template_results.hpp"

// Control torques of tasks in strict priority: every route, as templates and as programs, compared
// with the interpreter's recursion over joint accelerations and with runtime/core's elimination,
// for random robots whose tasks mostly cannot all be done. Would catch: rows that are eliminated in
// the wrong order or returned to the wrong place, a border of another point, a relaxed row that
// affects those above it, and a row that is relaxed without need.

namespace treeline::tests {
namespace {

using Matrix50 = interpreter::Matrix<Digits50>;
using Vector50 = interpreter::Vector<Digits50>;

/// Seven to nine joints, three points of up to six rows in three levels: for most robots more rows
/// than freedoms.
RandomMechanism crowded_robot(std::uint64_t seed) {
  RandomOptions options;
  options.joints = 7 + static_cast<int>(seed % 3);
  options.branching = seed % 3 == 0 ? 0.4 : 0.1;
  options.floating_base = seed % 2 == 0;
  options.mimic = seed % 5 == 0 ? 0.4 : 0;
  options.mix.planar = 1;
  if (seed % 7 == 6) options.mix.ball = 3;
  options.operational_points = 3;
  options.all_rows = seed % 4 == 1;
  options.external_forces = static_cast<int>(seed % 2);
  RandomMechanism made = random_mechanism(seed, options);
  constexpr std::array<std::array<int, 3>, 3> kOrders{{{3, 1, 2}, {2, 1, 1}, {1, 7, 2}}};
  for (std::size_t i = 0; i < 3; ++i) {
    made.scene.operational_points[i].priority = kOrders[seed % 3][i];
  }
  return made;
}

/// Whether every point can move in some row of each kind that it lists, as the contract requires.
bool can_move(const interpreter::Points<Digits50>& points, const Matrix50& A) {
  const Vector50 diagonal = A.diagonal();
  return interpreter::relaxation_borders<Digits50>(points, diagonal).minCoeff() > Digits50(1e-12);
}

struct Subject50 {
  explicit Subject50(const RandomMechanism& made)
      : model(model_from_robot<Digits50>(made.robot, made.scene)),
        points(points_from_scene(model, made.scene.operational_points)) {}
  interpreter::Model<Digits50> model;
  interpreter::Points<Digits50> points;
};

Vector50 vector50(const std::vector<Digits50>& values) {
  return Eigen::Map<const Vector50>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Calls `check(seed, robot, inputs)` for robots and states that the contract covers. Returns their
/// number.
template <class Check>
int for_each_crowd(std::uint64_t first, int count, Check check) {
  int checked = 0;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = crowded_robot(seed);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    Rng rng(seed + 11);
    const Inputs<Digits50> in = oracle.random_inputs(rng);
    const Subject50 subject(made);
    if (subject.model.nv == 0 || !can_move(subject.points, oracle.lambda_inverse(in))) continue;
    check(made, in);
    ++checked;
  }
  return checked;
}

TEST(Priorities, OfAllRoutesAreTheInterpretersInFiftyDigits) {
  std::size_t routes = 0;
  const int checked = for_each_crowd(1, 30, [&](const RandomMechanism& made, const auto& in) {
    const Oracle<Digits50> oracle(made.robot, made.scene);
    const Yardstick size = yardstick(oracle, in);
    const auto expected = oracle.results(Function::control_torque, in);
    const TemplateRun<Digits50> run(reduced_mechanism(made.robot, made.scene), in);
    for (const auto& [route, results] : run.results(Function::control_torque)) {
      // Relaxed rows may lose four digits each, because of the slope of their share.
      EXPECT_LE(relative_error(results, expected, size.force), 1e-30 * size.condition_M) << route;
      ++routes;
    }
  });
  EXPECT_GE(checked, 15);
  EXPECT_GE(routes, 3U * static_cast<unsigned>(checked));
}

TEST(Priorities, OfTheProgramsAreTheInterpretersInDouble) {
  double worst = 0;
  const int checked = for_each_crowd(40, 16, [&](const RandomMechanism& made, const auto& drawn) {
    const Oracle<Digits50> oracle(made.robot, made.scene);
    const auto in = rounded_to<double>(drawn);
    const auto exact = rounded_to<Digits50>(in);
    const Yardstick size = yardstick(oracle, exact);
    const auto expected = oracle.results(Function::control_torque, exact);
    for (const Program& program :
         trace_function(reduced_mechanism(made.robot, made.scene), Function::control_torque, 1)) {
      const auto results = evaluate<double>(program, CheckedPrograms::arguments(program, in));
      const double error = relative_error(results, expected, size.force) / size.condition_M;
      worst = std::max(worst, error);
      // Two rows at their borders at once cost 2^13 each.
      EXPECT_LE(error, 0x1p26 * 0x1p-52) << describe(program.route);
    }
  });
  std::cout << "worst error over the condition of M: " << worst * 0x1p52 << " ulp\n";
  EXPECT_GE(checked, 8);
}

/// F by runtime/core, in the order of the scene's rows.
template <int kRows>
Vector50 force_by_elimination(const interpreter::Points<Digits50>& points, const Matrix50& A,
                              const Vector50& lacks) {
  const auto rows = interpreter::rows_by_priority(points);
  const Vector50 diagonal = A.diagonal();
  const Vector50 all_borders = interpreter::relaxation_borders<Digits50>(points, diagonal);
  Digits50 packed[kRows * kRows], borders[kRows], x[kRows];
  for (int i = 0; i < kRows; ++i) {
    const int row = rows[static_cast<std::size_t>(i)];
    for (int j = 0; j < kRows; ++j) {
      packed[kRows * i + j] = A(row, rows[static_cast<std::size_t>(j)]);
    }
    borders[i] = all_borders(row);
    x[i] = lacks(row);
  }
  core::selective_solve(core::bordered_factor<kRows>(packed, borders), x);
  Vector50 F(kRows);
  for (int i = 0; i < kRows; ++i) F(rows[static_cast<std::size_t>(i)]) = x[i];
  return F;
}

// Twelve rows of two points with seven to nine joints.
TEST(Priorities, AreTheEliminationOfTheRuntimeInFiftyDigits) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    RandomMechanism made = crowded_robot(seed);
    made.scene.operational_points.resize(2);
    made.scene.external_forces.clear();
    for (ScenePoint& point : made.scene.operational_points) point.rows.fill(true);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    const Subject50 s(made);
    Rng rng(seed + 21);
    const Inputs<Digits50> in = oracle.random_inputs(rng);
    const Matrix50 A = oracle.lambda_inverse(in);
    if (!interpreter::has_priorities(s.points) || !can_move(s.points, A)) continue;
    ++checked;
    const Vector50 q = vector50(in.q), qd = vector50(in.qd), qdd = vector50(in.qdd);
    const Vector50 lacks = vector50(in.xdd_cmd) - interpreter::point_accelerations<Digits50>(
                                                      s.model, s.points, q, qd, qdd);
    const Vector50 F = force_by_elimination<12>(s.points, A, lacks);
    const Vector50 tau = interpreter::inverse_dynamics<Digits50>(s.model, q, qd, qdd) +
                         interpreter::jacobian<Digits50>(s.model, s.points, q).transpose() * F;
    const Yardstick size = yardstick(oracle, in);
    EXPECT_LE(relative_error(Results<Digits50>{listed(tau)},
                             oracle.results(Function::control_torque, in), size.force),
              1e-30 * size.condition_M);
  }
  EXPECT_GE(checked, 5);
}

/// Accelerations of the task rows under a torque.
Vector50 accelerations_under(const Subject50& s, const Inputs<Digits50>& in,
                             const std::vector<Digits50>& tau) {
  const Vector50 q = vector50(in.q), qd = vector50(in.qd);
  return interpreter::point_accelerations<Digits50>(
      s.model, s.points, q, qd,
      interpreter::forward_dynamics<Digits50>(s.model, q, qd, vector50(tau)));
}

/// The share that each row keeps, in the order of the scene's rows.
Vector50 shares_of(const interpreter::Points<Digits50>& points, const Matrix50& A) {
  const Vector50 diagonal = A.diagonal();
  const Vector50 borders = interpreter::relaxation_borders<Digits50>(points, diagonal);
  Matrix50 left = A;
  Vector50 shares(A.rows());
  for (const int row : interpreter::rows_by_priority(points)) {
    const Digits50 inverse = interpreter::relaxed_inverse<Digits50>(left(row, row), borders(row));
    shares(row) = inverse * left(row, row);
    const Vector50 column = left.col(row);
    left -= column * (inverse * column.transpose());
  }
  return shares;
}

// Meaning of strict priority: whatever lower rows command, the rows above that keep their whole
// share accelerate as commanded, and so do lower rows that are compatible with them.
TEST(Priorities, HigherTasksNeverNoticeLowerOnes) {
  int relaxed = 0, kept = 0;
  const int checked = for_each_crowd(70, 24, [&](const RandomMechanism& drawn, const auto& in) {
    RandomMechanism made = drawn;
    made.scene.external_forces.clear();
    const Subject50 s(made);
    const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    const Vector50 shares = shares_of(s.points, oracle.lambda_inverse(in));
    const auto rows = interpreter::rows_by_priority(s.points);
    Inputs<Digits50> first = in;
    first.f_ext.clear();
    Inputs<Digits50> second = first;
    for (std::size_t k = rows.size() / 2; k < rows.size(); ++k) {
      second.xdd_cmd[static_cast<std::size_t>(rows[k])] *= -100;
    }
    const auto run = [&](const Inputs<Digits50>& inputs) {
      const auto results =
          TemplateRun<Digits50>(mechanism, inputs).results(Function::control_torque);
      return accelerations_under(s, inputs, results.front().results.front());
    };
    const Vector50 a = run(first), b = run(second);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const int row = rows[k];
      // A share of 1 - 1e-16 has this error, times the forces that lower rows command.
      if (shares(row) < 1 - Digits50(1e-16)) {
        ++relaxed;
        continue;
      }
      ++kept;
      const auto at = static_cast<std::size_t>(row);
      EXPECT_LT(Digits50(abs(a(row) - first.xdd_cmd[at])), 1e-9) << "row " << row;
      EXPECT_LT(Digits50(abs(b(row) - second.xdd_cmd[at])), 1e-9) << "row " << row;
    }
  });
  EXPECT_GE(checked, 12);
  EXPECT_GT(relaxed, 40);
  EXPECT_GT(kept, 100);
}

}  // namespace
}  // namespace treeline::tests
