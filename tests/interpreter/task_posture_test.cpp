#include "interpreter/task_posture.hpp"

#include <gtest/gtest.h>

#include "core/prioritized_solve.hpp"
#include "interpreter/center_of_mass.hpp"
#include "interpreter/physics.hpp"
#include "interpreter/prioritized_torque.hpp"

// Posture torques, strict priorities and the centre of mass for random mechanisms. Would catch: a
// null-space torque and a posture acceleration that are not equivalent, a task that affects a more
// important one, a conflict that affects more than the less important task, and a centre of mass
// that omits a link or a mimic joint.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

Digits50 pivot_ratio(const Matrix50& A) {
  const Vector50 pivots = A.ldlt().vectorD().cwiseAbs();
  return pivots.minCoeff() == 0 ? Digits50("1e60")
                                : Digits50(pivots.maxCoeff() / pivots.minCoeff());
}

/// The first mechanism from the seed on whose controlled rows are independent.
Case regular_case(std::uint64_t first, const RandomOptions& options) {
  for (std::uint64_t seed = first;; ++seed) {
    Case c = random_case(seed, options);
    if (pivot_ratio(lambda_inverse<Digits50>(c.model, c.points, c.q)) < 1e8) return c;
  }
}

class TaskPosture : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Seeds, TaskPosture, testing::Range<std::uint64_t>(1, 9));

TEST_P(TaskPosture, PostureAccelerationStandsForTheNullSpaceTorque) {
  const Case c = regular_case(1000 * GetParam(), {.joints = 12,
                                                  .branching = 0.1,
                                                  .mix = {5, 1, 1, 0, 0.2, 0.5},
                                                  .floating_base = GetParam() % 2 == 0,
                                                  .operational_points = 2,
                                                  .all_rows = false});
  const auto o = explicit_operational_space<Digits50>(c.model, c.points, c.q);
  const Vector50 F = operational_force<Digits50>(
      o, c.xdd, bias_acceleration<Digits50>(c.model, c.points, c.q, c.qd),
      nonlinear_effects<Digits50>(c.model, c.q, c.qd));
  const Vector50 expected = task_posture_torque<Digits50>(o, F, c.tau);
  const Vector50 qdd_0 = posture_acceleration<Digits50>(c.model, c.q, c.qd, c.tau);
  EXPECT_LT(relative_error(control_torque<Digits50>(c.model, c.points, c.q, c.qd, qdd_0, c.xdd),
                           expected),
            kAlgebra * pivot_ratio(o.Lambda_inverse))
      << "seed " << 1000 * GetParam();
}

/// Treats each controlled row as a task of its own.
std::vector<Task<Digits50>> row_tasks(const Case& c) {
  std::vector<Task<Digits50>> tasks;
  for (const auto& point : c.points) {
    for (std::size_t row = 0; row < 6; ++row) {
      if (!point.rows[row]) continue;
      Task<Digits50> task{{point}, Vector50::Zero(1)};
      task.points[0].rows.fill(false);
      task.points[0].rows[row] = true;
      task.xdd_cmd(0) = c.xdd(static_cast<int>(tasks.size()));
      tasks.push_back(task);
    }
  }
  return tasks;
}

Points50 all_points(const std::vector<Task<Digits50>>& tasks) {
  Points50 points;
  for (const auto& task : tasks) {
    points.insert(points.end(), task.points.begin(), task.points.end());
  }
  return points;
}

Vector50 accelerations_under(const Case& c, const std::vector<Task<Digits50>>& tasks,
                             const Vector50& tau) {
  return point_accelerations<Digits50>(c.model, all_points(tasks), c.q, c.qd,
                                       forward_dynamics<Digits50>(c.model, c.q, c.qd, tau));
}

const Digits50 kConflict("1e-12");

TEST_P(TaskPosture, TasksWithoutConflictAreTheStackedTask) {
  const Case c = regular_case(3000 * GetParam(), {.joints = 10,
                                                  .branching = 0.1,
                                                  .mix = {5, 1, 0, 0, 0, 0.5},
                                                  .mimic = GetParam() % 3 == 0 ? 0.2 : 0,
                                                  .operational_points = 2,
                                                  .all_rows = false});
  const Vector50 tau =
      prioritized_torque<Digits50>(c.model, row_tasks(c), c.q, c.qd, c.qdd, kConflict);
  const Vector50 expected = control_torque<Digits50>(c.model, c.points, c.q, c.qd, c.qdd, c.xdd);
  EXPECT_LT(relative_error(tau, expected), Digits50("1e-30"));
}

// The points' priorities, row by row, are the same recursion as task by task. A row with a 300th of
// the largest pivot loses the share (300 / 2^13)^8, about 1e-11.
TEST_P(TaskPosture, PrioritiesOfPointsAreTheRecursion) {
  Case c;
  for (std::uint64_t seed = 9000 * GetParam();; ++seed) {
    c = random_case(seed, {.joints = 14,
                           .branching = 0.2,
                           .mix = {5, 1, 1, 0, 0, 0},
                           .floating_base = seed % 2 == 0,
                           .operational_points = 2,
                           .all_rows = false});
    if (pivot_ratio(lambda_inverse<Digits50>(c.model, c.points, c.q)) < 300) break;
  }
  c.points[0].priority = 2;
  const auto first = row_count<Digits50>({c.points[0]});
  const std::vector<Task<Digits50>> tasks{{{c.points[1]}, c.xdd.tail(c.xdd.size() - first)},
                                          {{c.points[0]}, c.xdd.head(first)}};
  const Vector50 expected =
      prioritized_torque<Digits50>(c.model, tasks, c.q, c.qd, c.qdd, kConflict);
  EXPECT_LT(relative_error(control_torque<Digits50>(c.model, c.points, c.q, c.qd, c.qdd, c.xdd),
                           expected),
            Digits50("1e-9"));
}

// Three points of one arm that does not have enough freedoms: the first tasks are achieved
// completely, whatever the later ones command.
TEST_P(TaskPosture, LaterTasksNeverDisturbEarlierOnes) {
  const Case c = random_case(
      5000 * GetParam(),
      {.joints = 7, .branching = 0, .mix = {1, 0, 0, 0, 0, 0}, .operational_points = 3});
  const auto tasks_with = [&c](const Digits50& factor) {
    std::vector<Task<Digits50>> tasks;
    for (int k = 0; k < 3; ++k) {
      const Vector50 wanted = c.xdd.segment(6 * k, 6) * (k == 0 ? Digits50(1) : factor);
      tasks.push_back({{c.points[static_cast<std::size_t>(k)]}, wanted});
    }
    return tasks;
  };
  const auto tasks = tasks_with(1);
  const auto others = tasks_with(-100);
  const auto first_rows = [&](const std::vector<Task<Digits50>>& all) {
    return Vector50(
        accelerations_under(c, all,
                            prioritized_torque<Digits50>(c.model, all, c.q, c.qd, c.qdd, kConflict))
            .head(6));
  };
  const Vector50 alone = first_rows({tasks[0]});
  EXPECT_LT(relative_error(first_rows(tasks), alone), Digits50("1e-20")) << 5000 * GetParam();
  EXPECT_LT(relative_error(first_rows(others), alone), Digits50("1e-20")) << 5000 * GetParam();
}

// The elimination of runtime/core in double compared with the recursion of projections in 50
// digits: a row that repeats the first one with another command, and a row that repeats the third
// one, are relaxed.
TEST_P(TaskPosture, EliminationIsTheRecursiveProjection) {
  constexpr int kRows = 8;
  const Case c = regular_case(
      7000 * GetParam(),
      {.joints = 12, .branching = 0, .mix = {4, 1, 0, 0, 0, 0}, .operational_points = 1});
  std::vector<Task<Digits50>> tasks = row_tasks(c);
  tasks.insert(tasks.begin() + 2, tasks[0]);
  tasks.insert(tasks.begin() + 5, tasks[3]);
  tasks[2].xdd_cmd(0) += 7;
  tasks[5].xdd_cmd(0) -= 9;
  const Points50 points = all_points(tasks);
  const Matrix50 A = lambda_inverse<Digits50>(c.model, points, c.q);
  const Vector50 already = point_accelerations<Digits50>(c.model, points, c.q, c.qd, c.qdd);
  double packed[kRows * kRows];
  double x[kRows];
  for (int i = 0; i < kRows; ++i) {
    for (int j = 0; j < kRows; ++j) packed[kRows * i + j] = static_cast<double>(A(i, j));
    x[i] = static_cast<double>(tasks[static_cast<std::size_t>(i)].xdd_cmd(0) - already(i));
  }
  const auto factors = core::prioritized_factor<kRows>(packed, 1e-11);
  core::selective_solve(factors, x);
  for (const int row : {0, 1, 3, 4, 6, 7}) EXPECT_EQ(factors.shares[row], 1.0) << row;
  for (const int row : {2, 5}) EXPECT_LT(factors.shares[row], 1e-8) << row;
  Vector50 F(kRows);
  for (int i = 0; i < kRows; ++i) F(i) = Digits50(x[i]);
  const Vector50 tau = inverse_dynamics<Digits50>(c.model, c.q, c.qd, c.qdd) +
                       jacobian<Digits50>(c.model, points, c.q).transpose() * F;
  const Vector50 expected =
      prioritized_torque<Digits50>(c.model, tasks, c.q, c.qd, c.qdd, kConflict);
  // Pivots spread by up to 1e8, and remainders of relaxed rows: half of double's digits.
  EXPECT_LT(relative_error(tau, expected), Digits50("1e-6")) << 7000 * GetParam();
  const Vector50 a = accelerations_under(c, tasks, tau);
  for (const int row : {0, 1, 3, 4, 6, 7}) {
    EXPECT_LT(Digits50(abs(a(row) - tasks[static_cast<std::size_t>(row)].xdd_cmd(0))),
              Digits50("1e-6") * scale(c.xdd))
        << "row " << row;
  }
}

class CenterOfMass : public testing::TestWithParam<NamedOptions> {};

INSTANTIATE_TEST_SUITE_P(Mechanisms, CenterOfMass, testing::ValuesIn(assorted_mechanisms()));

TEST_P(CenterOfMass, IsWherePotentialEnergySaysAndMovesWithMomentum) {
  const Case c = random_case(GetParam().seed, GetParam().options);
  const Digits50 mass = total_mass(c.model);
  const Vector3<Digits50> com = center_of_mass<Digits50>(c.model, c.q);
  Model50 other = c.model;
  for (int axis = 0; axis < 3; ++axis) {
    other.gravity = -Vector3<Digits50>::Unit(axis);
    EXPECT_LT(Digits50(abs(mass * com(axis) - potential_energy(other, c.q))),
              kAlgebra * mass * scale(com));
  }
  const Vector50 velocity = center_of_mass_jacobian<Digits50>(c.model, c.q) * c.qd;
  const Vector50 p = momentum(c.model, c.q, c.qd).head(3);
  EXPECT_LT(relative_error(Vector50(mass * velocity), p), kAlgebra);
}

// g = -m J_com^T gravity: what holds the robot at rest holds its centre of mass.
TEST_P(CenterOfMass, ItsJacobianCarriesGravity) {
  const Case c = random_case(GetParam().seed, GetParam().options);
  const Vector50 g =
      -total_mass(c.model) *
      (center_of_mass_jacobian<Digits50>(c.model, c.q).transpose() * c.model.gravity);
  EXPECT_LT(relative_error(g, gravity<Digits50>(c.model, c.q)), kAlgebra);
}

}  // namespace
}  // namespace treeline::tests
