#include <gtest/gtest.h>

#include "passes/count_operations.hpp"
#include "passes/schedule.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

// Would catch: a value used before it is computed, sines scattered through the code, values that
// change with the order.
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

TEST(Schedule, FinishesOneBranchBeforeTheNext) {
  Program program;
  {
    const Graph::Scope scope(program.graph);
    const auto x = test::input_vector("x", 4);
    program.graph.begin_section("outward");
    const Expression left = x[0] * x[1];
    const Expression right = x[2] * x[3];
    program.graph.begin_section("inward");
    program.results = {{{"y", 2, 1, ""}, {left + x[0], right + x[2]}}};
  }
  std::vector<std::string> titles;
  const Program scheduled = schedule(program);
  for (const Graph::Section& section : scheduled.graph.sections()) {
    titles.push_back(section.title);
  }
  EXPECT_EQ(titles, (std::vector<std::string>{"outward", "inward", "outward", "inward"}));
}

}  // namespace
}  // namespace treeline
