#pragma once

#include "contact_cases.hpp"

namespace treeline::test {

struct SolvedContacts {
  Vector y, v;
  core::ContactSolution<double> solution;
};

/// Solves a problem of up to 16 contacts from the impulses `start`.
inline SolvedContacts solve(const ContactProblem& problem, const Vector& start) {
  static core::ContactSolver<double, 16> solver;
  SolvedContacts solved{start, problem.v, {}};
  solved.solution = solver.solve(static_cast<int>(problem.laws.size()), problem.A.data(),
                                 problem.laws.data(), solved.v.data(), solved.y.data());
  return solved;
}

inline SolvedContacts solve(const ContactProblem& problem) {
  return solve(problem, Vector::Zero(problem.v.size()));
}

}  // namespace treeline::test
