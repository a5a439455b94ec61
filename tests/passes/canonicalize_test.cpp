#include <gtest/gtest.h>

#include "passes/passes.hpp"
#include "passes/two_link_arm.hpp"
#include "program/print.hpp"

// Would catch: emitted code that depends on the order in which a compiler evaluates operands.
namespace treeline {
namespace {

/// (x - y) z + (y - x) w + z x, with its operands built from left to right or from right to left.
Program trace(bool right_first) {
  Program program;
  program.name = "order";
  program.graph = Graph::for_trace(1);
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 4);
  program.arguments = {{"x", 4, 1, ""}};
  const auto first = [&] { return (x[0] - x[1]) * x[2]; };
  const auto second = [&] { return (x[1] - x[0]) * x[3]; };
  const auto third = [&] { return x[2] * x[0]; };
  Expression a;
  Expression b;
  Expression c;
  if (right_first) {
    c = third();
    b = second();
    a = first();
  } else {
    a = first();
    b = second();
    c = third();
  }
  program.results = {{{"y", 1, 1, ""}, {a + b + c}}};
  return program;
}

TEST(Canonicalize, ProgramDoesNotTellInWhichOrderItWasBuilt) {
  EXPECT_EQ(print_text(canonicalize(trace(false))), print_text(canonicalize(trace(true))));
}

TEST(Canonicalize, BuildsBothDifferencesOnce) {
  const Program program = canonicalize(trace(false));
  int differences = 0;
  for (const Node& node : program.graph.nodes()) {
    differences += node.op == Op::sub ? 1 : 0;
  }
  EXPECT_EQ(differences, 2);  // x0 - x1, and the sum of its two multiples
}

}  // namespace
}  // namespace treeline
