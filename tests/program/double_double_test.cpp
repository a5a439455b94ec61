#include "program/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "digits/digits50.hpp"
#include "passes/passes.hpp"
#include "program/program.hpp"

// Constants that follow from constants, against 50 digits. Would catch: one that is rounded before
// the last operation, cancellation that leaves rounding of 32 digits, and a rest that a copy of the
// graph or a limb loses.

namespace treeline::tests {
namespace {

Digits50 exact(const DoubleDouble& x) {
  return Digits50(x.value) + Digits50(x.rest);
}

/// Relative error of a result. Two roundings to 106 bits are below 2^-103.
double error_of(const DoubleDouble& computed, const Digits50& expected) {
  return static_cast<double>(Digits50(abs(exact(computed) - expected) / abs(expected)));
}

constexpr double kError = 0x1p-102;

/// A third, in both parts.
DoubleDouble third() {
  return DoubleDouble::from(Digits50(1) / 3);
}

TEST(DoubleDouble, HasThirtyTwoDigits) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> draw(0.1, 10);
  for (int i = 0; i < 1000; ++i) {
    const Digits50 x = Digits50(draw(random)) / 3, y = Digits50(draw(random)) / 7;
    const auto a = DoubleDouble::from(x), b = DoubleDouble::from(y);
    EXPECT_LT(error_of(a, x), kError);
    EXPECT_LT(error_of(a + b, x + y), kError);
    EXPECT_LT(error_of(a * b, x * y), kError);
    EXPECT_LT(error_of(a / b, x / y), kError);
    EXPECT_EQ((a * b).value, static_cast<double>(x * y));
  }
}

TEST(DoubleDouble, CancelsToZero) {
  const DoubleDouble x = third();
  EXPECT_EQ((x * 3 + -1.0).value, 0);
  EXPECT_EQ((x * x * 9 + -1.0).value, 0);
  EXPECT_LT(error_of(x + -x.value, Digits50(1) / 3 - Digits50(x.value)), 1e-15);
}

TEST(DoubleDouble, OverflowsAsDoublesDo) {
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ((DoubleDouble(most) * most).value, std::numeric_limits<double>::infinity());
  EXPECT_EQ((DoubleDouble(most) + most).value, std::numeric_limits<double>::infinity());
  EXPECT_EQ((DoubleDouble(1) / 0.0).value, std::numeric_limits<double>::infinity());
}

TEST(ConstantsOfAGraph, AreRoundedOnce) {
  Graph graph;
  const Graph::Scope scope(graph);
  const Expression x(third()), y = graph.input("x[0]");
  EXPECT_NE(7 * (1.0 / 3) - 2, 1.0 / 3);  // as doubles would have it
  EXPECT_EQ(7 * x - 2, x);
  EXPECT_EQ(1 - x - x - x, Expression());
  EXPECT_EQ(7 * x * y - 2 * y, x * y);
  EXPECT_EQ(7 * x * y / y - 2, x);
}

TEST(ConstantsOfAGraph, KeepTheirRestInLimbsAndCopies) {
  Program program;
  {
    const Graph::Scope scope(program.graph);
    const Expression x(third()), y = program.graph.input("x[0]");
    const Node limb = make_limb_constant({1, 0, 2}, x.constant());
    const Expression of_limb(program.graph.intern(limb, x.exact_constant().rest), false);
    EXPECT_EQ((7 * of_limb - 2).constant(), 1.0 / 3);
    program.results = {{{"y", 2, 1, ""}, {x * y, of_limb * y}}};
  }
  const Program copy = canonicalize(program);
  for (const Expression& value : copy.results.front().values) {
    const std::uint32_t factor = copy.graph.nodes()[value.node()].a;
    EXPECT_EQ(copy.graph.rest_of(factor), third().rest);
  }
}

}  // namespace
}  // namespace treeline::tests
