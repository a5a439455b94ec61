#include <gtest/gtest.h>

#include <cmath>

#include "passes/passes.hpp"
#include "program/evaluate.hpp"

// Would catch: an angle whose sine is given but computed nevertheless, a wrong sign in the addition
// theorem, and inputs that the arguments do not list.
namespace treeline {
namespace {

constexpr double kOffset = 0.7;

Program trace_angles() {
  Program program;
  program.name = "angles";
  program.arguments = {{"q", 3, 1, "angles, rad"}, {"other", 1, 1, "an angle, rad"}};
  const Graph::Scope scope(program.graph);
  const Expression a = program.graph.input("q[0]");
  const Expression b = program.graph.input("q[1]");
  const Expression other = program.graph.input("other[0]");
  program.results = {
      {{"out", 6, 1, "various"},
       {sin(a), cos(-b), sin(a + kOffset), cos(kOffset - b), sin(a - b), cos(a + b)}},
      {{"computed", 2, 1, "not of q alone"}, {sin(other), cos(a * 2)}}};
  return program;
}

int count_computed(const Program& program) {
  int count = 0;
  for (const Node& node : program.graph.nodes()) {
    count += node.op == Op::sin || node.op == Op::cos ? 1 : 0;
  }
  return count;
}

TEST(TakeSines, GivesTheSameNumbers) {
  const Program program = trace_angles();
  const Program taken = take_sines(program);
  ASSERT_EQ(taken.arguments.size(), 4U);
  EXPECT_EQ(taken.arguments[1].name, "sin_q");
  EXPECT_EQ(taken.arguments[2].name, "cos_q");
  EXPECT_EQ(taken.arguments[2].rows, 3);
  EXPECT_EQ(count_computed(taken), 2);
  const std::vector<double> q = {0.4, -1.3, 2.5};
  std::vector<double> sines;
  std::vector<double> cosines;
  for (const double angle : q) {
    sines.push_back(std::sin(angle));
    cosines.push_back(std::cos(angle));
  }
  const std::vector<double> other = {0.9};
  using Arguments = std::vector<std::vector<double>>;
  const auto expected = evaluate(program, Arguments{q, other});
  const auto actual = evaluate(taken, Arguments{q, sines, cosines, other});
  for (std::size_t r = 0; r < expected.size(); ++r) {
    for (std::size_t i = 0; i < expected[r].size(); ++i) {
      EXPECT_NEAR(actual[r][i], expected[r][i], 1e-15) << r << " " << i;  // a few roundings of 1
    }
  }
}

TEST(TakeSines, LeavesAFunctionWithoutAnglesAlone) {
  Program program;
  program.arguments = {{"q", 1, 1, "a length, m"}};
  const Graph::Scope scope(program.graph);
  const Expression x = program.graph.input("q[0]");
  program.results = {{{"out", 1, 1, "its square"}, {x * x}}};
  EXPECT_EQ(take_sines(program).arguments.size(), 1U);
}

}  // namespace
}  // namespace treeline
