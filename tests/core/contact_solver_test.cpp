#include "core/contact_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

// Would catch: impulses that pull, a cone that is a pyramid or too wide, restitution applied to
// contacts that separate, friction that drives, a sweep that stops before its fixed point, and
// divisions by mobilities that are 0: `converged` beside NaN, or beside a law that does not hold.

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

// A jaw moves along its normal and in no other direction: friction has nothing to do.
TEST(ContactSolver, ServesAJaw) {
  for (const double friction : {0.0, 0.4, 1e300, std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE(friction);
    Problem problem;
    problem.A = Matrix::Zero(3, 3);
    problem.A(0, 0) = 0.5;
    problem.v = Vector3d(-1, 0, 0);
    problem.laws.resize(1);
    Vector3d::Map(problem.laws[0].normal) = Vector3d(1, 0, 0);
    problem.laws[0].friction = friction;
    const Solved solved = solve(problem);
    EXPECT_TRUE(solved.solution.converged);
    EXPECT_EQ(solved.y, Vector(Vector3d(2, 0, 0)));
    EXPECT_EQ(solved.v, Vector(Vector3d(0, 0, 0)));
  }
}

/// Laws in the form that holds for every size of impulse: the four of contact, by their residuals.
/// `allowed` is a speed.
void expect_residuals(const Problem& problem, const Solved& solved, double allowed) {
  ASSERT_TRUE(solved.y.allFinite() && solved.v.allFinite());
  const double rounding = 1e-13 * (problem.A.cwiseAbs() * solved.y.cwiseAbs()).maxCoeff();
  EXPECT_LT((problem.v + problem.A * solved.y - solved.v).cwiseAbs().maxCoeff(),
            allowed + rounding);
  for (std::size_t i = 0; i < problem.laws.size(); ++i) {
    const auto& law = problem.laws[i];
    const Vector3d n = normal_of(law);
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Vector3d y = solved.y.segment<3>(row), v = solved.v.segment<3>(row);
    const double y_n = n.dot(y), v_n = n.dot(v);
    const double wanted = -law.restitution * n.dot(problem.v.segment<3>(row));
    EXPECT_GE(y_n, -1e-13 * y.norm());
    EXPECT_GE(v_n, wanted - allowed - rounding);                  // Signorini
    EXPECT_LE(y_n * (v_n - wanted), (allowed + rounding) * y_n);  // either
    const Vector3d y_t = y - y_n * n, v_t = v - v_n * n;
    if (std::isinf(law.friction)) {
      if (y_n > 0) EXPECT_LE(v_t.norm(), allowed + rounding);
      continue;
    }
    const double most = law.friction * y_n;
    const double of_cone =
        1e-13 * (1 + law.friction) * y.norm();   // rounding of y_n, times friction
    EXPECT_LE(y_t.norm(), most + of_cone);       // Coulomb
    EXPECT_LE(most * v_t.norm() + y_t.dot(v_t),  // sliding: the cone's edge, against the motion
              (allowed + rounding) * (most + y.norm()) + of_cone * v_t.norm());
  }
  const bool plastic = std::all_of(problem.laws.begin(), problem.laws.end(),
                                   [](const auto& law) { return law.restitution == 0; });
  const double sizes = solved.y.cwiseAbs().sum();
  if (plastic) EXPECT_LE(0.5 * solved.y.dot(problem.v + solved.v), (allowed + rounding) * sizes);
}

/// Mechanisms of few freedoms at contacts of which some are the same point, with freedoms along or
/// across a normal exactly, and inertias apart by up to 1e6.
Problem degenerate_problem(std::mt19937_64& engine, int trial) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto draw = [&] { return uniform(engine); };
  const int count = 1 + trial % 4, freedoms = trial / 4 % 6;
  Problem problem;
  Matrix J = Matrix::NullaryExpr(3 * count, freedoms, draw);
  for (Eigen::Index i = 0; i < freedoms; ++i) J.col(i) *= std::pow(10.0, 3 * draw());
  constexpr double kFrictions[] = {0, 0.4, 1, 3, 1e6, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < count; ++i) {
    ContactLaw<double> law;
    Vector3d n = Vector3d::NullaryExpr(draw).normalized();
    if (trial / 24 % 3 == 1) n = Vector3d::Unit(trial % 3);
    Vector3d::Map(law.normal) = n;
    auto own = J.middleRows(3 * i, 3);
    if (trial / 24 % 3 == 1 && i == 0) {  // a jaw
      for (Eigen::Index k = 0; k < freedoms; ++k) own.col(k) = Vector3d(n * draw());
    }
    if (trial / 24 % 3 == 2 && i > 0) own = J.topRows(3);  // twice the same point
    law.restitution = trial % 2 == 0 ? 0 : 0.5;
    law.friction = kFrictions[engine() % 6];
    problem.laws.push_back(law);
  }
  problem.A = J * J.transpose();
  problem.v = J * Vector::NullaryExpr(freedoms, draw);
  if (trial % 5 == 0) problem.v += Vector::NullaryExpr(3 * count, draw);  // what is touched moves
  return problem;
}

TEST(ContactSolver, NeverSaysConvergedBesideALawThatDoesNotHold) {
  constexpr unsigned kSeed = 7;
  std::mt19937_64 engine(kSeed);
  int converged = 0;
  constexpr int kTrials = 4000;
  for (int trial = 0; trial < kTrials; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
    const Problem problem = degenerate_problem(engine, trial);
    const Solved solved = solve(problem, {2000, 1e-12});
    if (!solved.solution.converged) continue;
    ++converged;
    // Each contact is off by the tolerance when it was visited, and by what the others move then.
    expect_residuals(problem, solved, 1e-11 * (1 + problem.v.cwiseAbs().maxCoeff()));
  }
  std::cout << converged << " of " << kTrials << " converged\n";
  EXPECT_GE(converged, kTrials / 2);
}

// One contact that can move along its normal, whatever else it can, has an answer.
TEST(ContactSolver, SolvesEveryBlockThatMovesAlongTheNormal) {
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const int freedoms = 1 + trial % 3;
    const Matrix J = Matrix::NullaryExpr(3, freedoms, [&] { return uniform(engine); });
    Problem problem;
    problem.A = J * J.transpose();
    problem.v = J * Vector::NullaryExpr(freedoms, [&] { return uniform(engine); });
    problem.laws.resize(1);
    Vector3d n = Vector3d::NullaryExpr([&] { return uniform(engine); }).normalized();
    if (freedoms == 1 && trial % 2 == 0) n = J.col(0).normalized();
    Vector3d::Map(problem.laws[0].normal) = n;
    problem.laws[0].friction = 0.2 * (trial % 8);
    const Solved solved = solve(problem, {100000, 1e-12});
    EXPECT_TRUE(solved.solution.converged);
    expect_residuals(problem, solved, 1e-11);
  }
}

TEST(ContactSolver, SaysThatNothingServes) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto solves = [](const auto& change) {
    Problem problem;
    problem.A = 0.5 * Matrix::Identity(3, 3);
    problem.v = Vector3d(0.1, 0, -1);
    problem.laws.resize(1);
    problem.laws[0].friction = 0.4;
    change(problem);
    return solve(problem).solution.converged;
  };
  EXPECT_TRUE(solves([](Problem&) {}));
  EXPECT_FALSE(solves([](Problem& p) { p.A.setZero(); }));  // nothing moves
  EXPECT_FALSE(solves([](Problem& p) { p.A(2, 2) = 0; }));  // nothing along the normal
  EXPECT_TRUE(solves([](Problem& p) { p.A.setZero(), p.v(2) = 0; }));
  EXPECT_FALSE(solves([](Problem& p) { p.A(2, 2) = 1e-17; }));  // nothing but rounding
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity()}) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_FALSE(solves([&](Problem& p) { p.v(i) = bad; }));
      EXPECT_FALSE(solves([&](Problem& p) { p.A(i, i) = bad; }));
      EXPECT_FALSE(solves([&](Problem& p) { p.laws[0].normal[i] = bad; }));
    }
    EXPECT_FALSE(solves([&](Problem& p) { p.laws[0].restitution = bad; }));
    EXPECT_FALSE(solves([&](Problem& p) { p.laws[0].parting = bad; }));
  }
  EXPECT_FALSE(solves([&](Problem& p) { p.laws[0].friction = kNaN; }));
  EXPECT_FALSE(solves([&](Problem& p) { p.laws[0].friction = -0.1; }));
}

TEST(ContactSolver, SaysWhenItGaveUp) {
  std::mt19937_64 engine(4);
  const Problem problem = random_problem(engine, 5, 19, 0.5);
  EXPECT_FALSE(solve(problem, {1, 1e-12}).solution.converged);
  EXPECT_TRUE(solve(problem, {100000, 1e-12}).solution.converged);
}

}  // namespace
}  // namespace treeline::core
