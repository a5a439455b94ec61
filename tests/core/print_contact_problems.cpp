// Random problems of contacts as JSON, one a line, with what ContactSolver finds and the time that
// it takes, for judges/contacts.py. Usage: print_contact_problems PROBLEMS, of each kind and size;
// or print_contact_problems PROBLEMS KIND 4|16: how many of one do not converge.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "contact_cases.hpp"

namespace {

using namespace treeline::test;  // NOLINT: the cases

constexpr const char* kNames[] = {"matrix", "redundant", "graded", "legs", "bodies"};

void print_numbers(const char* name, const double* numbers, Eigen::Index count) {
  std::printf("\"%s\": [", name);
  for (Eigen::Index i = 0; i < count; ++i) std::printf("%s%.17g", i > 0 ? ", " : "", numbers[i]);
  std::printf("], ");
}

template <int most>
void print_problem(const char* kind, const ContactProblem& problem) {
  const auto solver = std::make_unique<treeline::core::ContactSolver<double, most>>();
  treeline::core::ContactSolution<double> solution;
  Vector y;
  double microseconds = 1e300;
  for (int turn = 0; turn < 5; ++turn) {
    Vector v = problem.v;
    y = Vector::Zero(v.size());
    const auto start = std::chrono::steady_clock::now();
    solution = solver->solve(most, problem.A.data(), problem.laws.data(), v.data(), y.data());
    const std::chrono::duration<double, std::micro> taken =
        std::chrono::steady_clock::now() - start;
    microseconds = std::min(microseconds, taken.count());
  }
  std::printf("{\"kind\": \"%s\", \"contacts\": %d, ", kind, most);
  print_numbers("A", problem.A.data(), problem.A.size());
  print_numbers("v", problem.v.data(), problem.v.size());
  std::vector<double> normals, frictions;
  for (const auto& law : problem.laws) {
    normals.insert(normals.end(), law.normal, law.normal + 3);
    frictions.push_back(law.friction);
  }
  print_numbers("normals", normals.data(), static_cast<Eigen::Index>(normals.size()));
  print_numbers("frictions", frictions.data(), static_cast<Eigen::Index>(frictions.size()));
  print_numbers("y", y.data(), y.size());
  std::printf("\"converged\": %s, \"microseconds\": %.3f}\n", solution.converged ? "true" : "false",
              microseconds);
}

template <int most>
void count_unconverged(ContactKind kind, int problems) {
  const auto solver = std::make_unique<treeline::core::ContactSolver<double, most>>();
  ContactDraw draw(50);
  int unconverged = 0;
  for (int i = 0; i < problems; ++i) {
    ContactProblem problem = draw.problem(kind, most);
    Vector y = Vector::Zero(problem.v.size());
    const auto solution =
        solver->solve(most, problem.A.data(), problem.laws.data(), problem.v.data(), y.data());
    unconverged += solution.converged ? 0 : 1;
  }
  std::printf("%d of %d\n", unconverged, problems);
}

}  // namespace

int main(int count, char** arguments) {
  const int problems = count > 1 ? std::atoi(arguments[1]) : 10;
  for (const ContactKind kind : kContactKinds) {
    const char* const name = kNames[static_cast<int>(kind)];
    if (count == 4) {
      if (arguments[2] != std::string_view(name)) continue;
      std::atoi(arguments[3]) == 4 ? count_unconverged<4>(kind, problems)
                                   : count_unconverged<16>(kind, problems);
      continue;
    }
    ContactDraw draw(40 + static_cast<unsigned>(kind));
    for (int i = 0; i < problems; ++i) print_problem<4>(name, draw.problem(kind, 4));
    for (int i = 0; i < problems; ++i) print_problem<16>(name, draw.problem(kind, 16));
  }
}
