#include <gtest/gtest.h>

#include <limits>

#include "solve_contacts.hpp"

// Contacts whose impulses are known without a solver. Would catch: a wrong textbook case of
// restitution or friction, divisions by mobilities that are 0, and `converged` beside NaN, beside
// data that mean nothing, and where nothing can move.

namespace treeline::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// One contact that sticks, computed by hand: a ball against a wall with A = 1/m, e = 0.5, at 45
// degrees.
TEST(SimpleContacts, OfOneContactIsTheTextbooks) {
  ContactProblem problem;
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
TEST(SimpleContacts, ServesAJaw) {
  for (const double friction : {0.0, 0.4, 1e300, kInfinity}) {
    SCOPED_TRACE(friction);
    ContactProblem problem;
    problem.A = Matrix::Zero(3, 3);
    problem.A(0, 0) = 0.5;
    problem.v = Vector3d(-1, 0, 0);
    problem.laws.resize(1);
    Vector3d::Map(problem.laws[0].normal) = Vector3d(1, 0, 0);
    problem.laws[0].friction = friction;
    const SolvedContacts solved = solve(problem);
    EXPECT_TRUE(solved.solution.converged);
    EXPECT_EQ(solved.y, Vector(Vector3d(2, 0, 0)));
    EXPECT_EQ(solved.v, Vector(Vector3d(0, 0, 0)));
  }
}

TEST(SimpleContacts, SaysThatNothingServes) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto solves = [](const auto& change) {
    ContactProblem problem;
    problem.A = 0.5 * Matrix::Identity(3, 3);
    problem.v = Vector3d(0.1, 0, -1);
    problem.laws.resize(1);
    problem.laws[0].friction = 0.4;
    change(problem);
    return solve(problem).solution.converged;
  };
  EXPECT_TRUE(solves([](ContactProblem&) {}));
  EXPECT_FALSE(solves([](ContactProblem& p) { p.A.setZero(); }));  // nothing moves
  EXPECT_FALSE(solves([](ContactProblem& p) { p.A(2, 2) = 0; }));  // nothing along the normal
  EXPECT_TRUE(solves([](ContactProblem& p) { p.A.setZero(), p.v(2) = 0; }));
  EXPECT_FALSE(solves([](ContactProblem& p) { p.A(2, 2) = 1e-17; }));  // nothing but rounding
  for (const double bad : {kNaN, kInfinity}) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_FALSE(solves([&](ContactProblem& p) { p.v(i) = bad; }));
      EXPECT_FALSE(solves([&](ContactProblem& p) { p.A(i, i) = bad; }));
      EXPECT_FALSE(solves([&](ContactProblem& p) { p.laws[0].normal[i] = bad; }));
    }
    EXPECT_FALSE(solves([&](ContactProblem& p) { p.laws[0].restitution = bad; }));
  }
  EXPECT_FALSE(solves([&](ContactProblem& p) { p.laws[0].friction = kNaN; }));
  EXPECT_FALSE(solves([&](ContactProblem& p) { p.laws[0].friction = -0.1; }));
}

}  // namespace
}  // namespace treeline::test
