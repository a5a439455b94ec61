#include "bounds/bound_rounding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>

#include "bounds/lie_on_circle.hpp"
#include "generate.hpp"
#include "hill_climber.hpp"
#include "sample.hpp"

// Would catch: bounds that omit the rounding of an operation, that grow with every rotation, or
// that are stated where nothing is known.

namespace treeline::tests {
namespace {

RoundingBound bound_of(const Sample& sample, Solve solve = Solve::none) {
  return bound_rounding(sample.program, sample.domain, kUnit, solve);
}

TEST(BoundRounding, CountsEveryRounding) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 2, 3);
  sample.result({x[0] + x[1], x[0] * x[1], Expression(0.1) * x[0], Expression(0.5) * x[0]});
  const RoundingBound bound = bound_of(sample);
  ASSERT_TRUE(bound.is_proven());
  // Rounding of the sum and of the products, but not of the product with a power of two.
  EXPECT_NEAR(bound.error[0], 6 * kUnit, 1e-9 * kUnit);
  EXPECT_NEAR(bound.error[1], 9 * kUnit, 1e-9 * kUnit);
  EXPECT_NEAR(bound.error[2], 0.3 * kUnit, 1e-9 * kUnit);
  EXPECT_EQ(bound.error[3], 0);
  EXPECT_NEAR(bound.size[1], 9, 1e-9);
}

/// A vector of length at most sqrt 3 is rotated forty times about x and z. By magnitudes alone the
/// bound of its entries would exceed 1e4.
TEST(BoundRounding, RotationsDoNotLengthenVectors) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  auto v = sample.argument("x", 3, 1);
  const auto q = sample.argument("q", 40, 3);
  for (const Expression& angle : q) {
    const Expression c = cos(angle), s = sin(angle);
    v = {c * v[0] - s * v[1], v[2], s * v[0] + c * v[1]};
  }
  sample.result(v);
  const RoundingBound bound = bound_of(sample);
  for (const double size : bound.size) EXPECT_LE(size, 1.7321);
  // Largest error of one rotation: two products and a sum, and sine and cosine with 2 units each,
  // for two entries and values below sqrt 3.
  for (const double error : bound.error) EXPECT_LE(error, 40 * 2 * 5 * 1.7321 * 1.4143 * kUnit);
}

/// Symmetric matrices, rotated by the eleven operations that recursions use, do not grow in the
/// bounds.
TEST(BoundRounding, RotationsDoNotEnlargeMatrices) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 3, 1);
  const auto q = sample.argument("q", 30, 3);
  Expression a = x[0], b = x[1], d = x[2];
  for (const Expression& angle : q) {
    const Expression c = cos(angle), s = sin(angle);
    const Expression t = s * (a - d) + c * (Expression(2.0) * b);
    a = a - s * t;
    d = d + s * t;
    b = c * t - b;
  }
  sample.result({a, b, d});
  const RoundingBound bound = bound_of(sample);
  for (const double size : bound.size) EXPECT_LE(size, 4);  // by themselves above 1e5
  for (const double error : bound.error) EXPECT_LE(error, 30 * 200 * kUnit);
  HillClimber climber(sample.program, sample.domain, 3);
  for (std::size_t i = 0; i < 3; ++i) climber.hill_climb(i, 300);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LE(climber.worst[i], bound.error[i]);
}

TEST(BoundRounding, SaysWhyThereIsNone) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 2, 3);
  sample.result({x[0] + x[1]});
  sample.domain.sizes.clear();
  EXPECT_EQ(bound_of(sample).kind, RoundingBound::Kind::none);
  EXPECT_EQ(bound_of(sample).missing, "no range is stated for x[0]");
  EXPECT_EQ(RoundingBound{}.kind, RoundingBound::Kind::none);
}

/// Functions with a division are searched. If a divisor may vanish, the bound holds for a share of
/// the states.
TEST(BoundRounding, QuotientsAreBoundedToFirstOrder) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 2, 3);
  sample.result({x[0] / (Expression(2.0) * x[1])});
  const RoundingBound searched = bound_of(sample, Solve::mass_matrix);
  EXPECT_EQ(searched.kind, RoundingBound::Kind::searched);
  EXPECT_TRUE(searched.is_first_order());
  EXPECT_EQ(searched.worst.size(), 1);
  const RoundingBound typical = bound_of(sample, Solve::lambda_inverse);
  EXPECT_EQ(typical.kind, RoundingBound::Kind::typical);
  EXPECT_NE(describe(typical, sample.program, kUnit).find("99 of 100 states"), std::string::npos);
}

/// One rotation of a vector of length at most sqrt 2 (entries up to 1). Errors of products and
/// sines count with the vector's length. Counted separately they would give 5 for each entry.
TEST(BoundRounding, RoundingsOfATurnCountTogether) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 2, 1);
  const auto q = sample.argument("q", 1, 3);
  const Expression c = cos(q[0]), s = sin(q[0]);
  sample.result({c * x[0] + s * x[1]});
  const double sqrt2 = std::sqrt(2.0);
  const RoundingBound bound = bound_of(sample);
  // Products 1, sines sqrt 2, the sum 1, times the length.
  EXPECT_LE(bound.error[0], (2 + sqrt2) * sqrt2 * kUnit * (1 + 1e-6));
  HillClimber climber(sample.program, sample.domain, 5);
  climber.hill_climb(0, 3000);
  EXPECT_LE(climber.worst[0], bound.error[0]);
}

/// Moves y e from one side of a rotation to the other, as recursions do that take accelerations
/// from a parent. Products as large as 4 cancel, and one input is left.
TEST(BoundRounding, ProductsCancelThroughTurns) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 5, 1);
  const auto q = sample.argument("q", 2, 3);
  const Expression c0 = cos(q[0]), s0 = sin(q[0]), c1 = cos(q[1]), s1 = sin(q[1]);
  const Expression a = c0 * x[0] + s0 * x[1], b = c0 * x[1] - s0 * x[0], e = c0 * x[2] + s0 * x[3];
  const Expression y = c1 * a + s1 * b;
  sample.result({x[4] + (y * e - (c1 * (a * e) + s1 * (b * e)))});
  const RoundingBound bound = bound_of(sample);
  EXPECT_NEAR(bound.size[0], 1, 1e-9);
  EXPECT_LE(bound.error[0], 40 * kUnit);
  HillClimber climber(sample.program, sample.domain, 4);
  climber.hill_climb(0, 3000);
  EXPECT_LE(climber.worst[0], bound.error[0]);
  EXPECT_LE(bound.error[0], 20 * climber.worst[0]);
}

TEST(BoundRounding, SinesMayBeGiven) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 2, 1);
  const auto s = sample.argument("sin_q", 1, 1);
  const auto c = sample.argument("cos_q", 1, 1);
  sample.result({c[0] * x[0] + s[0] * x[1]});
  EXPECT_LE(bound_of(sample).size[0], 1.4143);
}

/// Ratio of the worst error found to the bound, over all entries.
double hill_climb_given(const Program& program, const Domain& domain, const RoundingBound& bound,
                        HillClimber::Given given, int steps) {
  HillClimber climber(program, domain, 11, given);
  double worst = 0;
  for (std::size_t i = 0; i < bound.error.size(); i += 1 + bound.error.size() / 12) {
    climber.hill_climb(i, steps);
  }
  for (std::size_t i = 0; i < bound.error.size(); ++i) {
    if (bound.error[i] > 0) worst = std::max(worst, climber.worst[i] / bound.error[i]);
  }
  return worst;
}

/// In the whole box |sin_q| <= 1, |cos_q| <= 1, a rotation may lengthen vectors by sqrt 2. So the
/// bound does not hold there, and it must state that it assumes pairs on the unit circle.
TEST(BoundRounding, GivenSinesMustLieOnTheCircle) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  auto v = sample.argument("x", 3, 1);
  const auto s = sample.argument("sin_q", 12, 1);
  const auto c = sample.argument("cos_q", 12, 1);
  for (std::size_t i = 0; i < s.size(); ++i) {
    v = {c[i] * v[0] - s[i] * v[1], v[2], s[i] * v[0] + c[i] * v[1]};
  }
  sample.result(v);
  const RoundingBound bound = bound_of(sample);
  const auto worst = [&](HillClimber::Given given) {
    return hill_climb_given(sample.program, sample.domain, bound, given, 2000);
  };
  EXPECT_LE(worst(HillClimber::Given::on_circle), 1);
  EXPECT_GT(worst(HillClimber::Given::in_box), 2);
  EXPECT_NE(describe(sample.domain, {"cos_q", "sin_q", "x"}).find("sin_q^2 + cos_q^2 = 1"),
            std::string::npos);
  EXPECT_EQ(describe(sample.domain, {"x"}), "|x| <= 1");
}

/// Robots' own functions with given sines: the header and the manifest must state the circle.
TEST(BoundRounding, RobotsWithGivenSinesStateTheCircle) {
  const Subjects made = load_functions("humanoid24", {Function::jacobian}, Sines::given);
  const GeneratedFunction& jacobian = made.generation.functions.front();
  ASSERT_TRUE(jacobian.rounding.is_proven());
  const auto worst = [&](HillClimber::Given given) {
    return hill_climb_given(jacobian.program, made.generation.domain, jacobian.rounding, given,
                            400);
  };
  const double on_circle = worst(HillClimber::Given::on_circle);
  const double in_box = worst(HillClimber::Given::in_box);
  std::printf("humanoid24 jacobian, worst found over bound: %.2f on the circle, %.2f in the box\n",
              on_circle, in_box);
  EXPECT_LE(on_circle, 1);
  EXPECT_GT(in_box, 1);
  for (const GeneratedFile& file : made.generation.files) {
    if (file.name != "humanoid24.hpp" && file.name != "manifest.json") continue;
    const std::string text = std::regex_replace(file.text, std::regex("\\n// +"), " ");
    EXPECT_NE(text.find("sin_q^2 + cos_q^2 = 1"), std::string::npos) << file.name;
  }
}

TEST(LieOnCircle, AllowsRoundingAlone) {
  EXPECT_TRUE(lie_on_circle({std::sin(1.0), 0}, {std::cos(1.0), -1}, kUnit));
  EXPECT_FALSE(lie_on_circle({std::sin(1.0), 0.5}, {std::cos(1.0), 0.5}, kUnit));
  EXPECT_FALSE(lie_on_circle({1 + 1e-14}, {0}, kUnit));
  EXPECT_TRUE(lie_on_circle({std::sin(1.0F)}, {std::cos(1.0F)}, 0x1p-24));
  EXPECT_FALSE(lie_on_circle({std::nan("")}, {0}, kUnit));
}

TEST(Describe, NeverSaysLessThanTheBound) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 1, 1.23456);
  sample.result({Expression(3.0) * x[0]});
  EXPECT_EQ(describe(bound_of(sample), sample.program, kUnit),
            "at most 4.2e-16 in r (at r[0]), 1 ulp of 3.8e+00, the most that r can be");
  EXPECT_EQ(describe(sample.domain, {"x"}), "|x| <= 1.234");
}

}  // namespace
}  // namespace treeline::tests
