// Would catch: sums that are taken for turned vectors and are none, and pairs without length 1.
#include "certify/unit_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "program/evaluate.hpp"

namespace treeline::tests {
namespace {

/// Two angles a and b, and a vector (x, y) turned by both.
struct Turned {
  Program program;
  Expression cosine, sine, u, v;

  Turned() {
    const Graph::Scope scope(program.graph);
    program.arguments = {{"q", 2, 1, ""}, {"x", 2, 1, ""}};
    const Expression a = program.graph.input("q[0]"), b = program.graph.input("q[1]");
    const Expression x = program.graph.input("x[0]"), y = program.graph.input("x[1]");
    cosine = cos(a) * cos(b) - sin(a) * sin(b);
    sine = sin(a) * cos(b) + cos(a) * sin(b);
    u = cosine * x - sine * y;
    v = sine * x + cosine * y;
  }

  std::vector<double> values(double a, double b, double x, double y) const {
    std::vector<double> all;
    for (const Node& node : program.graph.nodes()) {
      all.push_back(evaluate_node(node, all, {a, b, x, y}));
    }
    return all;
  }
};

double value_of(const LinearRow& row, const std::vector<double>& values) {
  double sum = 0;
  for (const auto& [node, factor] : row) sum += factor * values[node];
  return sum;
}

TEST(UnitPairs, AreSinesAndCosinesOfAnglesAndOfTheirSum) {
  const Turned turned;
  const UnitPairs pairs(turned.program.graph);
  ASSERT_EQ(pairs.all().size(), 3U);
  const auto values = turned.values(0.3, 1.1, 2, -3);
  for (const UnitPair& pair : pairs.all()) {
    EXPECT_NEAR(std::hypot(values[pair.cosine], values[pair.sine]), 1, 1e-15);
  }
  EXPECT_TRUE(pairs.pair_of(turned.cosine.node()));
  EXPECT_FALSE(pairs.pair_of(turned.u.node()));
}

TEST(UnitPairs, ExpandRowsToEqualSums) {
  const Turned turned;
  const UnitPairs pairs(turned.program.graph);
  const auto values = turned.values(0.3, 1.1, 2, -3);
  const auto by = pairs.turn(turned.u.node());
  ASSERT_TRUE(by);
  const UnitPair& pair = pairs.all()[*by];
  std::vector<TurnedRow> rows;
  for (const Expression& value : {turned.u, turned.v}) {
    const TurnedRow row = pairs.expand({{value.node(), 2}}, *by);
    EXPECT_NEAR(2 * values[value.node()],
                values[pair.cosine] * value_of(row.cosine, values) +
                    values[pair.sine] * value_of(row.sine, values) + value_of(row.rest, values),
                1e-14);
    rows.push_back(row);
  }
  EXPECT_TRUE(are_mates(rows[0], rows[1]));
  EXPECT_FALSE(are_mates(rows[0], rows[0]));
}

/// cos a x + sin a y and cos a x - sin a y are not the coordinates of a turned vector.
TEST(UnitPairs, KnowReflectedRowsApart) {
  Program program;
  const Graph::Scope scope(program.graph);
  const Expression a = program.graph.input("q[0]");
  const Expression x = program.graph.input("x[0]"), y = program.graph.input("x[1]");
  const Expression u = cos(a) * x + sin(a) * y, v = cos(a) * x - sin(a) * y;
  const UnitPairs pairs(program.graph);
  const auto by = pairs.turn(u.node());
  ASSERT_TRUE(by);
  EXPECT_FALSE(are_mates(pairs.expand({{u.node(), 1}}, *by), pairs.expand({{v.node(), 1}}, *by)));
}

}  // namespace
}  // namespace treeline::tests
