#include <gtest/gtest.h>

#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

// Would catch: a value that is used before it is computed, sines scattered through the code, and
// values that depend on the order.
namespace treeline {
namespace {

TEST(Schedule, OperandsComeFirst) {
  const Program arm = schedule(test::trace_two_link_arm());
  const std::vector<Node>& nodes = arm.graph.nodes();
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (operation(nodes[i].op).operands > 0) {
      EXPECT_LT(nodes[i].a, i);
      EXPECT_LT(nodes[i].b, i);
    }
  }
}

TEST(Schedule, SinesAndCosinesStandTogetherAfterTheirAngles) {
  const Program arm = schedule(test::trace_two_link_arm());
  std::string kinds;
  for (const Node& node : arm.graph.nodes()) {
    if (operation(node.op).operands > 0) {
      kinds += operation(node.op).operands == 1 ? 't' : 'a';
    }
  }
  EXPECT_EQ(kinds.substr(0, 6), "atttta");
  EXPECT_EQ(kinds.find('t', 5), std::string::npos);
}

TEST(Schedule, SineOfASineIsScheduledToo) {
  Program program;
  {
    const Graph::Scope scope(program.graph);
    const Expression x = program.graph.input("x[0]");
    program.results = {{{"y", 1, 1, ""}, {sin(sin(x) + x) + cos(x)}}};
  }
  program.arguments = {{"x", 1, 1, ""}};
  EXPECT_EQ(evaluate<double>(schedule(program), {{0.7}}), evaluate<double>(program, {{0.7}}));
}

TEST(Schedule, KeepsValuesAndCountsToTheBit) {
  const Program arm = test::trace_two_link_arm();
  const Program scheduled = schedule(arm);
  const std::vector<std::vector<double>> arguments = {{0.3, -1.1}, {2.0, 0.7}, {-0.4, 5.0}};
  EXPECT_EQ(evaluate(arm, arguments), evaluate(scheduled, arguments));
  EXPECT_EQ(count_operations(arm).flops(), count_operations(scheduled).flops());
}

/// Two branches, far longer than the interleaving window, that are traced in alternation.
TEST(Schedule, FinishesOneBranchBeforeTheNext) {
  constexpr int kLength = 400;
  Program program;
  {
    const Graph::Scope scope(program.graph);
    const auto x = test::input_vector("x", 4);
    Expression left = x[0] * x[1];
    Expression right = x[2] * x[3];
    for (int i = 0; i < kLength; ++i) {
      left = (left + x[0]) * x[1];
      right = (right + x[2]) * x[3];
      if (i == kLength / 2) program.graph.name(right, "half_of_the_right");
    }
    program.results = {{{"y", 2, 1, ""}, {left, right}}};
  }
  const Program scheduled = schedule(program);
  for (std::uint32_t node = 0; node <= scheduled.results[0].values[0].node(); ++node) {
    EXPECT_EQ(scheduled.graph.names().of(node), "");
  }
  EXPECT_EQ(scheduled.graph.names().size(), 1u);
}

}  // namespace
}  // namespace treeline
