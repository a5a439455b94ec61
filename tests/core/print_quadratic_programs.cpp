// Random quadratic programs and their solutions as JSON, one a line, for check_with_cvxopt.py.
#include <cstdio>
#include <random>

#include "quadratic_cases.hpp"

namespace {

using namespace treeline::test;  // NOLINT: the cases

/// Infinite numbers as JSON has them in Python.
void print_numbers(const char* name, const double* numbers, int count, const char* after = ", ") {
  std::printf("\"%s\": [", name);
  for (int i = 0; i < count; ++i) {
    const char* const text = numbers[i] > 0 ? "Infinity" : "-Infinity";
    if (std::isfinite(numbers[i])) {
      std::printf("%s%.17g", i > 0 ? ", " : "", numbers[i]);
    } else {
      std::printf("%s%s", i > 0 ? ", " : "", text);
    }
  }
  std::printf("]%s", after);
}

template <int N, int M>
void print_programs(int count) {
  std::mt19937 engine(N);
  for (const Kind& kind : kKinds) {
    if (kind.conflicting || kind.decades > 0) continue;  // cvxopt answers neither
    for (int i = 0; i < count; ++i) {
      const auto problem = random_case<N, M>(kind, engine);
      const auto solution = solve(problem);
      std::printf("{\"n\": %d, \"m\": %d, ", N, M);
      print_numbers("H", problem.H, N * N);
      print_numbers("g", problem.g, N);
      print_numbers("lowest", problem.rows.lowest, N);
      print_numbers("highest", problem.rows.highest, N);
      print_numbers("A", problem.rows.A, M * N);
      print_numbers("lower", problem.rows.lower, M);
      print_numbers("upper", problem.rows.upper, M);
      print_numbers("x", solution.x, N, "}\n");
    }
  }
}

}  // namespace

int main() {
  print_programs<5, 12>(5);
  print_programs<20, 30>(5);
  print_programs<40, 60>(3);
}
