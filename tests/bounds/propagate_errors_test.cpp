#include "bounds/propagate_errors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "interpreter/digits50.hpp"
#include "passes/random_program.hpp"
#include "program/evaluate.hpp"

// Would catch: derivatives with respect to the wrong operand, roundings that are forgotten or
// counted where there are none, and states that are mixed up.

namespace treeline::bounds {
namespace {

using interpreter::Digits50;

constexpr double kDouble = 0x1p-53, kFloat = 0x1p-24;

/// One node over inputs x[0], x[1], ...
struct Sample {
  Graph graph;

  std::vector<Expression> inputs(int count) {
    std::vector<Expression> x;
    for (int i = 0; i < count; ++i) x.push_back(graph.input(fmt::format("x[{}]", i)));
    return x;
  }
  States bound(Expression value, const std::vector<States>& at, double unit = kDouble) const {
    ErrorPropagation errors(graph, unit);
    errors.evaluate(at);
    return errors.bound(value.node());
  }
};

States all(double x) {
  States states;
  states.fill(x);
  return states;
}

TEST(PropagateErrors, EachOperationByHand) {
  Sample sample;
  const Graph::Scope scope(sample.graph);
  const auto x = sample.inputs(3);
  const std::vector<States> at{all(3), all(-2), all(0.5)};
  const auto bound = [&](Expression value) { return sample.bound(value, at)[0]; };
  EXPECT_DOUBLE_EQ(bound(x[0] + x[1]), 1);
  EXPECT_DOUBLE_EQ(bound(x[0] - x[1]), 5);
  EXPECT_DOUBLE_EQ(bound(x[0] * x[1]), 6);
  EXPECT_DOUBLE_EQ(bound(x[0] / x[1]), 1.5);
  EXPECT_DOUBLE_EQ(bound((x[0] + x[1]) * x[2]), 0.5 + 0.5);
  EXPECT_DOUBLE_EQ(bound((x[0] - x[1]) / x[2]), 5 / 0.5 + 10);
  EXPECT_DOUBLE_EQ(bound(x[2] / (x[0] - x[1])), 0.5 / 25 * 5 + 0.1);
  EXPECT_DOUBLE_EQ(bound(sin(x[0])), 2 * std::sin(3.0));  // an ulp, which is two units
  EXPECT_DOUBLE_EQ(bound(cos(x[0])), 1);
  EXPECT_DOUBLE_EQ(bound(sin(x[0] - x[1])), 5 * std::cos(5.0) + 1);
  EXPECT_DOUBLE_EQ(bound(cos(x[0] - x[1])), 5 * -std::sin(5.0) + 2 * std::cos(5.0));
  const Expression square = x[0] * x[0];
  EXPECT_DOUBLE_EQ(bound(square * square), 2 * 9 * 9 + 81);  // one node, both operands
}

TEST(PropagateErrors, WhatIsExactCostsNothing) {
  Sample sample;
  const Graph::Scope scope(sample.graph);
  const auto x = sample.inputs(1);
  const Expression third = Expression(1.0 / 3) * x[0];
  EXPECT_EQ(sample.bound(Expression(0.25) * x[0], {all(3)})[0], 0);
  EXPECT_EQ(sample.bound(x[0], {all(3)})[0], 0);
  EXPECT_DOUBLE_EQ(sample.bound(third, {all(3)})[0], 1);
  EXPECT_DOUBLE_EQ(sample.bound(third, {all(3)}, kFloat)[0], 2);  // the constant, then the product
}

TEST(PropagateErrors, UnderflowIsAnError) {
  Sample sample;
  const Graph::Scope scope(sample.graph);
  const auto x = sample.inputs(1);
  EXPECT_GE(sample.bound(x[0] * x[0], {all(1e-200)})[0], 0x1p-1022);
}

TEST(PropagateErrors, StatesAreApart) {
  Sample sample;
  const Graph::Scope scope(sample.graph);
  const auto x = sample.inputs(2);
  States first, second;
  for (std::size_t s = 0; s < kStatesAtOnce; ++s) {
    first[s] = static_cast<double>(s + 1);
    second[s] = 2;
  }
  const States bound = sample.bound(x[0] * x[1], {first, second});
  for (std::size_t s = 0; s < kStatesAtOnce; ++s) EXPECT_DOUBLE_EQ(bound[s], 2 * first[s]);
}

/// Comparison with 50 digits: no error exceeds the bound, some are not far below it, and sampled
/// errors lie between.
TEST(PropagateErrors, BoundsTheErrorsOfRandomPrograms) {
  double nearest = 0, sampled = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Program program = test::random_program(seed, 60);
    std::mt19937_64 random(seed);
    std::vector<States> inputs(5);
    for (States& input : inputs) {
      for (double& x : input) x = std::ldexp(static_cast<double>(random() >> 11), -52) - 1;
    }
    ErrorPropagation errors(program.graph, kDouble);
    std::vector<States> at;
    for (const InputPlace& place : locate_inputs(program)) at.push_back(inputs[place.element]);
    errors.evaluate(at);
    errors.sample(seed);
    for (std::size_t s = 0; s < kStatesAtOnce; ++s) {
      std::vector<double> x;
      for (const States& input : inputs) x.push_back(input[s]);
      const auto rough = evaluate<double>(program, {x});
      const auto exact = evaluate<Digits50>(program, {std::vector<Digits50>(x.begin(), x.end())});
      for (std::size_t i = 0; i < rough[0].size(); ++i) {
        const std::uint32_t node = program.results[0].values[i].node();
        const double bound = errors.bound(node)[s] * kDouble;
        const auto error = static_cast<double>(Digits50(abs(exact[0][i] - rough[0][i])));
        ASSERT_LE(error, bound * (1 + 1e-9)) << "entry " << i << " state " << s;
        ASSERT_LE(std::abs(errors.sampled(node)[s]) * kDouble, bound * (1 + 1e-9));
        if (bound == 0) continue;
        nearest = std::max(nearest, error / bound);
        sampled = std::max(sampled, std::abs(errors.sampled(node)[s]) * kDouble / bound);
      }
    }
  }
  EXPECT_GT(nearest, 0.5);
  EXPECT_GT(sampled, 0.5);
}

}  // namespace
}  // namespace treeline::bounds
