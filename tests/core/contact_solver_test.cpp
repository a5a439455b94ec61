#include "core/contact_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <iostream>
#include <random>
#include <vector>

// Would catch: impulses that pull, a cone that is a pyramid or too wide, restitution applied to
// contacts that separate, friction that drives, and a sweep that stops before its fixed point.

namespace treeline::core {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;
using Eigen::Vector3d;

struct Problem {
  Matrix A;
  Vector v;
  std::vector<ContactLaw<double>> laws;
};

struct Solved {
  Vector y, v;
  ContactSolution solution;
};

Solved solve(const Problem& problem, const ContactSolverSettings<double>& settings = {}) {
  const int count = static_cast<int>(problem.laws.size());
  Solved solved{Vector::Zero(3 * count), problem.v, {}};
  std::vector<double> wanted(problem.laws.size());
  solved.solution =
      solve_contacts<double>(count, problem.A.data(), problem.laws.data(), solved.v.data(),
                             solved.y.data(), wanted.data(), settings);
  return solved;
}

Vector3d normal_of(const ContactLaw<double>& law) {
  return Vector3d::Map(law.normal);
}

/// `count` contacts of a mechanism with `freedoms`; fewer than 3k make A singular.
Problem random_problem(std::mt19937_64& engine, int count, int freedoms, double friction) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto draw = [&] { return uniform(engine); };
  Problem problem;
  const Matrix J = Matrix::NullaryExpr(3 * count, freedoms, draw);
  problem.A = J * J.transpose();
  problem.v = J * Vector::NullaryExpr(freedoms, draw);
  for (int i = 0; i < count; ++i) {
    ContactLaw<double> law;
    const Vector3d n = Vector3d::NullaryExpr(draw).normalized();
    Vector3d::Map(law.normal) = n;
    law.restitution = 0.5 + 0.5 * draw();
    law.friction = friction;
    problem.laws.push_back(law);
  }
  return problem;
}

void expect_law(const Problem& problem, const Solved& solved, double tolerance) {
  EXPECT_TRUE(solved.solution.converged);
  EXPECT_LT((problem.v + problem.A * solved.y - solved.v).norm(), 1e-12 * (1 + problem.v.norm()));
  for (std::size_t i = 0; i < problem.laws.size(); ++i) {
    const auto& law = problem.laws[i];
    const Vector3d n = normal_of(law);
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Vector3d y = solved.y.segment<3>(row), v = solved.v.segment<3>(row);
    const double before = n.dot(problem.v.segment<3>(row));
    const double wanted = -law.restitution * before;
    EXPECT_GE(n.dot(y), -1e-15);
    EXPECT_GE(n.dot(v), wanted - tolerance);
    EXPECT_NEAR(n.dot(y) * (n.dot(v) - wanted), 0, tolerance);
    const Vector3d y_t = y - n.dot(y) * n, v_t = v - n.dot(v) * n;
    EXPECT_LE(y_t.norm(), law.friction * n.dot(y) + 1e-14 * (1 + y.norm()));
    if (law.friction == 0 || v_t.norm() < tolerance) continue;
    // Sliding: impulse at the cone's edge and opposite to the motion.
    EXPECT_LT((y_t + law.friction * n.dot(y) * v_t.normalized()).norm(), 1e3 * tolerance);
  }
}

/// Solves the frictionless problem by trying which contacts act: exact, 2^k linear systems.
Vector by_enumeration(const Problem& problem) {
  const int count = static_cast<int>(problem.laws.size());
  Matrix N = Matrix::Zero(count, 3 * count);
  Vector wanted(count);
  for (int i = 0; i < count; ++i) {
    const auto& law = problem.laws[static_cast<std::size_t>(i)];
    N.block<1, 3>(i, 3 * i) = normal_of(law).transpose();
    wanted(i) = -law.restitution * normal_of(law).dot(problem.v.segment<3>(3 * i));
  }
  const Matrix A = N * problem.A * N.transpose();
  const Vector lack = wanted - N * problem.v;
  for (int set = 0; set < (1 << count); ++set) {
    std::vector<int> acting;
    for (int i = 0; i < count; ++i) {
      if ((set >> i & 1) != 0) acting.push_back(i);
    }
    Vector y = Vector::Zero(count);
    if (!acting.empty()) {
      const Vector some = Matrix(A(acting, acting)).ldlt().solve(Vector(lack(acting)));
      y(acting) = some;
    }
    if (y.minCoeff() > -1e-12 && (A * y - lack).minCoeff() > -1e-10) return N.transpose() * y;
  }
  ADD_FAILURE() << "no set of contacts solves it";
  return Vector::Zero(3 * count);
}

TEST(ContactSolver, WithoutFrictionFindsTheOneSolution) {
  std::mt19937_64 engine(1);
  int most = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    const int count = 1 + trial % 6;
    const Problem problem = random_problem(engine, count, 3 * count + 4, 0);
    const Solved solved = solve(problem, {200000, 1e-13});
    expect_law(problem, solved, 1e-9);
    EXPECT_LT((solved.y - by_enumeration(problem)).norm(), 1e-7 * (1 + solved.y.norm()));
    most = std::max(most, solved.solution.sweeps);
  }
  std::cout << "most sweeps: " << most << '\n';
}

// With more contacts than the mechanism has freedoms, impulses are not unique but velocities are.
TEST(ContactSolver, WithoutFrictionServesRedundantContacts) {
  std::mt19937_64 engine(2);
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(trial);
    Problem problem = random_problem(engine, 6, 4, 0);
    for (auto& law : problem.laws) law.restitution = 0;
    const Solved solved = solve(problem, {200000, 1e-12});
    expect_law(problem, solved, 1e-8);
    // Without restitution every impulse removes energy.
    EXPECT_LE(solved.y.dot(problem.v + solved.v), 1e-10);
  }
}

// One e for all contacts, whatever their coupling, and whether they approach or separate.
TEST(ContactSolver, WithoutFrictionMakesNoEnergy) {
  std::mt19937_64 engine(5);
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    const double e = 0.5 * (trial % 3);
    Problem problem = random_problem(engine, 2 + trial % 4, 19, 0);
    for (auto& law : problem.laws) law.restitution = e;
    const Solved solved = solve(problem, {200000, 1e-13});
    const double work = 0.5 * solved.y.dot(problem.v + solved.v);
    EXPECT_NEAR(work, 0.5 * (1 - e) * solved.y.dot(problem.v), 1e-9);
    EXPECT_LE(work, 1e-9);
  }
}

TEST(ContactSolver, WithFrictionEndsAtCoulombsLaw) {
  std::mt19937_64 engine(3);
  int converged = 0, most = 0;
  const int trials = 100;
  for (int trial = 0; trial < trials; ++trial) {
    SCOPED_TRACE(trial);
    const int count = 1 + trial % 5;
    const double friction = trial % 2 == 0 ? 0.3 : 1;
    const Problem problem = random_problem(engine, count, 3 * count + 4, friction);
    const Solved solved = solve(problem, {200000, 1e-12});
    if (!solved.solution.converged) continue;
    ++converged;
    most = std::max(most, solved.solution.sweeps);
    expect_law(problem, solved, 1e-8);
  }
  std::cout << converged << " of " << trials << " converged, most sweeps " << most << '\n';
  EXPECT_GE(converged, trials * 9 / 10);
}

// One contact that sticks, computed by hand: a ball against a wall with A = 1/m, e = 0.5, at 45
// degrees.
TEST(ContactSolver, OfOneContactIsTheTextbooks) {
  Problem problem;
  problem.A = 0.5 * Matrix::Identity(3, 3);
  problem.v = Vector3d(1, 0, -1);
  problem.laws.resize(1);
  problem.laws[0].restitution = 0.5;
  const auto expect = [&](double friction, const Vector3d& y) {
    problem.laws[0].friction = friction;
    EXPECT_LT((solve(problem).y - y).norm(), 1e-12) << friction;
  };
  expect(0, {0, 0, 3});       // 2 kg from -1 to 0.5 m/s
  expect(0.2, {-0.6, 0, 3});  // slides on
  expect(10, {-2, 0, 3});     // stops across
  problem.v = Vector3d(1, 0, 0.1);
  expect(10, {0, 0, 0});  // parts already
}

TEST(ContactSolver, SaysWhenItGaveUp) {
  std::mt19937_64 engine(4);
  const Problem problem = random_problem(engine, 5, 19, 0.5);
  EXPECT_FALSE(solve(problem, {1, 1e-12}).solution.converged);
  EXPECT_TRUE(solve(problem, {100000, 1e-12}).solution.converged);
}

}  // namespace
}  // namespace treeline::core
