#pragma once

#include <random>
#include <string>
#include <vector>

#include "passes/two_link_arm.hpp"

namespace treeline::test {

using Inputs = std::vector<Expression>;

/// A program of inputs x with the results y that `make` makes of them.
template <class Make>
Program program_of(int inputs, Make make) {
  Program program;
  program.arguments = {{"x", inputs, 1, ""}};
  const Graph::Scope scope(program.graph);
  const Inputs values = make(input_vector("x", inputs));
  program.results = {{{"y", static_cast<int>(values.size()), 1, ""}, values}};
  return program;
}

/// A random program of `operations` sums, products and a few quotients and sines over five inputs.
/// The last values are the results. The program is deep and has many common subexpressions, like
/// traced recursions.
inline Program random_program(unsigned seed, int operations) {
  std::mt19937 random(seed);
  Program program;
  program.name = "random";
  program.arguments = {{"x", 5, 1, ""}};
  const Graph::Scope scope(program.graph);
  std::vector<Expression> values = input_vector("x", 5);
  const auto pick = [&] { return values[random() % values.size()]; };
  for (int i = 0; i < operations; ++i) {
    const Expression a = pick();
    const Expression b = pick();
    switch (random() % 8) {
      case 0:
      case 1:
        values.push_back(a + b * pick());
        break;
      case 2:
        values.push_back(a - b * pick());
        break;
      case 3:
        values.push_back(0.3 * a + b);
        break;
      case 4:
        values.push_back(a * pick() * 0.1 - b * a * 0.1);
        break;
      case 5:
        values.push_back(a / (3 + cos(b)));
        break;
      default:
        values.push_back(sin(a) * b);
        break;
    }
    if (random() % 4 == 0) {
      program.graph.name(values.back(), "v" + std::to_string(i));
    }
  }
  const std::vector<Expression> results(values.end() - 8, values.end());
  program.results = {{{"y", 8, 1, ""}, results}};
  return program;
}

}  // namespace treeline::test
