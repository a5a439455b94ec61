#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

// Would catch: an operation that is lost or placed before its operands, a pack or pair of sines
// that is separated, and chains in sequence that could run in parallel.
namespace treeline {
namespace {

/// Two chains of products that meet only in their sum, one after the other, followed by a pack.
Program two_chains() {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 4);
  Expression first = x[0] * x[1];
  for (int i = 0; i < 5; ++i) first *= x[static_cast<std::size_t>(i % 3)];
  Expression second = x[2] * x[3];
  for (int i = 0; i < 5; ++i) second *= x[static_cast<std::size_t>(3 - i % 3)];
  const Expression sum = first + second;
  const Expression left = sum * x[0];
  const Expression right = sum * x[1];
  program.packs.push_back({left.node(), right.node()});
  program.arguments = {{"x", 4, 1, ""}};
  program.results = {{{"y", 2, 1, ""}, {left, right}}};
  return program;
}

std::vector<std::uint32_t> all_nodes(const Program& program) {
  std::vector<std::uint32_t> order(program.graph.nodes().size());
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

std::ptrdiff_t place_of(const std::vector<std::uint32_t>& order, std::uint32_t node) {
  return std::find(order.begin(), order.end(), node) - order.begin();
}

TEST(Interleave, ChainsRunSideBySide) {
  const Program program = two_chains();
  const auto order = interleave(program, all_nodes(program), 0);
  ASSERT_EQ(order.size(), program.graph.nodes().size());
  const auto& nodes = program.graph.nodes();
  const std::uint32_t sum = nodes[program.packs[0][0]].a;
  const std::ptrdiff_t first = place_of(order, nodes[sum].a);
  const std::ptrdiff_t second = place_of(order, nodes[sum].b);
  EXPECT_LE(std::abs(first - second), 2);
}

TEST(Interleave, KeepsValuesPacksAndTheHead) {
  const Program program = two_chains();
  const std::size_t head = 9;
  const auto order = interleave(program, all_nodes(program), head);
  for (std::uint32_t i = 0; i < head; ++i) {
    EXPECT_EQ(order[i], i);
  }
  const auto& pack = program.packs[0];
  EXPECT_EQ(std::abs(place_of(order, pack[0]) - place_of(order, pack[1])), 1);
  const std::vector<std::vector<double>> arguments = {{0.3, -7.1, 2.5, 1.25}};
  EXPECT_EQ(evaluate(rebuild(program, order), arguments), evaluate(program, arguments));
}

}  // namespace
}  // namespace treeline
