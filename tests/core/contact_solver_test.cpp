#include "core/contact_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <iostream>
#include <limits>

#include "emitted_contacts.h"
#include "solve_contacts.hpp"

// Would catch: impulses that pull, a cone that is a pyramid or too wide, restitution applied to
// contacts that separate, friction that drives, energy from nothing, `converged` beside a law that
// does not hold or beside NaN, masses far apart that cost digits, divisions by mobilities that are
// 0, and steps without a bound.

namespace treeline::test {
namespace {

using core::ContactLaw;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How far impulses are from the laws, by the criteria of Le Lidec et al. (2023): of the cone of
/// impulses and of complementarity beside the largest impulse, of velocities beside the largest
/// term of a velocity. All are computed from A, v and y alone, in world axes.
struct Residuals {
  double impulses = 0;         ///< by how much one leaves its cone
  double velocities = 0;       ///< by how much u, with De Saxce's term, leaves the dual cone
  double complementarity = 0;  ///< |y . (u + friction |u_t| n)|

  [[nodiscard]] double worst() const { return std::max({impulses, velocities, complementarity}); }
};

Residuals residuals_of(const ContactProblem& problem, const Vector& y, double restitution) {
  const Vector v = problem.v + problem.A * y;
  const double largest = std::max(1e-300, y.cwiseAbs().maxCoeff());
  const double speed =
      std::max(1e-300, (problem.v.cwiseAbs() + problem.A.cwiseAbs() * y.cwiseAbs()).maxCoeff());
  Residuals worst;
  for (std::size_t i = 0; i < problem.laws.size(); ++i) {
    const auto& law = problem.laws[i];
    const Vector3d n = normal_of(law);
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Vector3d own = y.segment<3>(row), after = v.segment<3>(row);
    const double y_n = n.dot(own);
    const double wanted = -restitution * law.restitution * n.dot(problem.v.segment<3>(row));
    const double u_n = n.dot(after) - wanted;
    const Vector3d y_t = own - y_n * n, u_t = after - n.dot(after) * n;
    const double friction = std::min(law.friction, 1e6);
    const double beyond = std::max(-y_n, (y_t.norm() - friction * y_n) / (1 + friction));
    const double work = y_n * u_n + y_t.dot(u_t) + friction * y_n * u_t.norm();
    worst.impulses = std::max(worst.impulses, beyond / largest);
    worst.velocities = std::max(worst.velocities, -u_n / speed);
    worst.complementarity =
        std::max(worst.complementarity, std::abs(work) / (speed * largest * (1 + friction)));
  }
  return worst;
}

/// J that impulses give, beside the sum of its terms' sizes.
double energy_of(const ContactProblem& problem, const Vector& y) {
  const Vector moved = problem.A * y;
  const double terms =
      y.cwiseAbs().dot(problem.v.cwiseAbs()) + 0.5 * y.cwiseAbs().dot(moved.cwiseAbs());
  return y.dot(problem.v + 0.5 * moved) / std::max(terms, 1e-300);
}

constexpr double kResidual = 1e-10;
constexpr double kEnergy = 1e-9;  // rounding of terms that cancel

/// What holds for every problem, whether it converged or not.
void expect_sound(const ContactProblem& problem, const SolvedContacts& solved) {
  ASSERT_TRUE(solved.y.allFinite() && solved.v.allFinite());
  const Vector v = problem.v + problem.A * solved.y;
  const Vector terms = problem.v.cwiseAbs() + problem.A.cwiseAbs() * solved.y.cwiseAbs();
  EXPECT_LE((v - solved.v).norm(), 1e-13 * terms.norm());
  const Residuals residuals = residuals_of(problem, solved.y, solved.solution.restitution);
  EXPECT_LT(residuals.impulses, kResidual);
  EXPECT_LE(energy_of(problem, solved.y), kEnergy);
  EXPECT_LE(solved.solution.steps, core::kMostContactSteps);
  if (solved.solution.converged) EXPECT_LT(residuals.worst(), kResidual);
}

/// Solves the frictionless problem by trying which contacts act: exact, 2^k linear systems.
Vector by_enumeration(const ContactProblem& problem) {
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

/// The problem without friction, which has one solution in v.
ContactProblem without_friction(ContactProblem problem, ContactDraw& draw, bool bounces) {
  for (auto& law : problem.laws) {
    law.friction = 0;
    law.restitution = bounces ? 0.5 + 0.5 * draw.number() : 0;
  }
  return problem;
}

TEST(ContactSolver, WithoutFrictionFindsTheOneSolution) {
  constexpr unsigned kSeed = 1;
  ContactDraw draw(kSeed);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
    const ContactProblem problem =
        without_friction(draw.problem(ContactKind::matrix, 1 + trial % 6), draw, true);
    const SolvedContacts solved = solve(problem);
    if (solved.solution.restitution < 1) continue;  // different coefficients may make energy
    EXPECT_TRUE(solved.solution.converged);
    expect_sound(problem, solved);
    EXPECT_LT((solved.y - by_enumeration(problem)).norm(), 1e-9 * (1 + solved.y.norm()));
  }
}

/// What a thousand random problems of each kind came to.
struct Tally {
  int unconverged = 0, most_steps = 0;
  double worst = 0;
};

Tally solve_many(ContactKind kind, int count, int trials, unsigned seed) {
  ContactDraw draw(seed);
  Tally tally;
  for (int trial = 0; trial < trials; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", trial " << trial);
    const ContactProblem problem = draw.problem(kind, count);
    const SolvedContacts solved = solve(problem);
    expect_sound(problem, solved);
    tally.unconverged += solved.solution.converged ? 0 : 1;
    tally.most_steps = std::max(tally.most_steps, solved.solution.steps);
    if (!solved.solution.converged) continue;
    tally.worst = std::max(tally.worst, residuals_of(problem, solved.y, 1).worst());
  }
  std::cout << "kind " << static_cast<int>(kind) << ", " << count
            << " contacts: " << tally.unconverged << " of " << trials
            << " unconverged, residuals to " << tally.worst << ", steps to " << tally.most_steps
            << '\n';
  return tally;
}

TEST(ContactSolver, SolvesEveryProblemOfRobotsAndOfMatricesOfFullRank) {
  for (const ContactKind kind : {ContactKind::matrix, ContactKind::legs}) {
    for (const int count : {1, 4, 16}) {
      EXPECT_EQ(solve_many(kind, count, 2000 / count, 20).unconverged, 0);
    }
  }
}

// Contacts that jam bodies of masses far apart from all sides are where it may end without a
// solution, and says so.
TEST(ContactSolver, SolvesAlmostAllThatDependOnEachOther) {
  for (const ContactKind kind :
       {ContactKind::redundant, ContactKind::graded, ContactKind::bodies}) {
    for (const int count : {1, 4, 16}) {
      const int trials = 1600 / count;
      EXPECT_LE(solve_many(kind, count, trials, 30).unconverged, trials / 20);
    }
  }
}

// Newton's law of restitution with friction may make energy; then coefficients are reduced, and the
// laws hold with what is left of them.
TEST(ContactSolver, NeverMakesEnergy) {
  constexpr unsigned kSeed = 5;
  ContactDraw draw(kSeed);
  int reduced = 0;
  for (const ContactKind kind : kContactKinds) {
    for (int trial = 0; trial < 200; ++trial) {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
      ContactProblem problem = draw.problem(kind, 1 + trial % 5);
      for (auto& law : problem.laws) law.restitution = 0.5 * (trial % 3);
      const SolvedContacts solved = solve(problem);
      expect_sound(problem, solved);
      reduced += solved.solution.restitution < 1 ? 1 : 0;
    }
  }
  std::cout << reduced << " of 1000 with less restitution\n";
  EXPECT_GT(reduced, 0);
}

// With e = 1 for all and no friction energy stays, so nothing is reduced.
TEST(ContactSolver, KeepsTheEnergyOfElasticBlows) {
  constexpr unsigned kSeed = 6;
  ContactDraw draw(kSeed);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
    ContactProblem problem =
        without_friction(draw.problem(ContactKind::legs, 1 + trial % 8), draw, false);
    for (auto& law : problem.laws) law.restitution = 1;
    const SolvedContacts solved = solve(problem);
    EXPECT_TRUE(solved.solution.converged);
    EXPECT_EQ(solved.solution.restitution, 1);
    EXPECT_LT(std::abs(energy_of(problem, solved.y)), kEnergy);
  }
}

// What was found before is found again, by a fraction of the steps.
TEST(ContactSolver, StartsWhereItEnded) {
  constexpr unsigned kSeed = 9;
  ContactDraw draw(kSeed);
  long cold = 0, warm = 0;
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
    const ContactProblem problem = draw.problem(ContactKind::legs, 8);
    const SolvedContacts first = solve(problem), second = solve(problem, first.y);
    expect_sound(problem, second);
    EXPECT_LT((second.v - first.v).norm(), 1e-8 * problem.v.norm());
    cold += first.solution.steps;
    warm += second.solution.steps;
  }
  EXPECT_LT(warm, cold);
}

// The headers as C, and as members of a template: the same bits.
TEST(ContactSolver, GivesTheBitsOfItsC) {
  ContactDraw draw(10);
  for (int trial = 0; trial < 100; ++trial) {
    const ContactProblem problem = draw.problem(ContactKind::legs, kContactsOfC);
    std::vector<double> normals, frictions;
    for (const auto& law : problem.laws) {
      normals.insert(normals.end(), law.normal, law.normal + 3);
      frictions.push_back(law.friction);
    }
    Vector y = Vector::Zero(problem.v.size()), v = problem.v;
    EXPECT_TRUE(solve_contacts_in_c(problem.A.data(), normals.data(), frictions.data(), v.data(),
                                    y.data()));
    core::ContactSolver<double, kContactsOfC> solver;
    Vector y_cpp = Vector::Zero(problem.v.size()), v_cpp = problem.v;
    solver.solve(kContactsOfC, problem.A.data(), problem.laws.data(), v_cpp.data(), y_cpp.data());
    EXPECT_EQ(y, y_cpp);
    EXPECT_EQ(v, v_cpp);
  }
}

/// Mechanisms of few freedoms at contacts of which some are the same point, with freedoms along or
/// across a normal exactly, and inertias apart by up to 1e6.
ContactProblem degenerate_problem(ContactDraw& draws, int trial) {
  const auto draw = [&] { return draws.number(); };
  const int count = 1 + trial % 4, freedoms = trial / 4 % 6;
  ContactProblem problem;
  Matrix J = Matrix::NullaryExpr(3 * count, freedoms, draw);
  for (Eigen::Index i = 0; i < freedoms; ++i) J.col(i) *= std::pow(10.0, 1.5 * draw());
  constexpr double kFrictions[] = {0, 0.4, 1, 3, 1e6, kInfinity};
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
    law.friction = kFrictions[draws.below(6)];
    problem.laws.push_back(law);
  }
  problem.A = J * J.transpose();
  problem.v = J * Vector::NullaryExpr(freedoms, draw);
  if (trial % 5 == 0) problem.v += Vector::NullaryExpr(3 * count, draw);  // what is touched moves
  return problem;
}

TEST(ContactSolver, NeverSaysConvergedBesideALawThatDoesNotHold) {
  constexpr unsigned kSeed = 7;
  ContactDraw draw(kSeed);
  int converged = 0;
  constexpr int kTrials = 1500;
  for (int trial = 0; trial < kTrials; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
    const ContactProblem problem = degenerate_problem(draw, trial);
    const SolvedContacts solved = solve(problem);
    expect_sound(problem, solved);
    converged += solved.solution.converged ? 1 : 0;
  }
  std::cout << converged << " of " << kTrials << " converged\n";
  EXPECT_GE(converged, kTrials / 2);
}

// One contact that can move along its normal, whatever else it can, has an answer.
TEST(ContactSolver, SolvesEveryBlockThatMovesAlongTheNormal) {
  ContactDraw draw(8);
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const int freedoms = 1 + trial % 3;
    const Matrix J = draw.matrix(3, freedoms);
    ContactProblem problem{J * J.transpose(), J * draw.matrix(freedoms, 1), {{}}};
    Vector3d n = draw.vector().normalized();
    if (freedoms == 1 && trial % 2 == 0) n = J.col(0).normalized();
    Vector3d::Map(problem.laws[0].normal) = n;
    problem.laws[0].friction = 0.2 * (trial % 8);
    const SolvedContacts solved = solve(problem);
    EXPECT_TRUE(solved.solution.converged);
    expect_sound(problem, solved);
  }
}

}  // namespace
}  // namespace treeline::test
