#include "bounds/search_rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bounds/draw_inputs.hpp"
#include "bounds/propagate_errors.hpp"
#include "generate.hpp"
#include "hill_climber.hpp"
#include "sample.hpp"

// Would catch: searches that stop before the worst states of a domain, or leave it.

namespace treeline::tests {
namespace {

using bounds::FoundError;
using bounds::SearchEffort;

TEST(SearchWorst, FindsTheCornerAndTheEntry) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto x = sample.argument("x", 2, 3);
  sample.result({x[0] * x[1] * Expression(0.1), x[0] * x[1]});
  const auto worst = bounds::search_worst(sample.program, sample.domain, kUnit, {});
  ASSERT_EQ(worst.size(), 1);
  EXPECT_DOUBLE_EQ(worst[0].error, 9);
  EXPECT_EQ(worst[0].entry, 1);
  EXPECT_DOUBLE_EQ(worst[0].size, 9);
}

/// 1 / (1.01 + cos q) is worst at q = pi: cos has an error of one unit there, which is amplified a
/// hundredfold twice.
TEST(SearchWorst, ClimbsANarrowPeak) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto q = sample.argument("q", 1, 3.141592653589793);
  sample.result({Expression(1.0) / (Expression(1.01) + cos(q[0]))});
  const auto worst = bounds::search_worst(sample.program, sample.domain, kUnit, {});
  EXPECT_NEAR(worst[0].error, 1e4 * (1 + 0.01) + 100, 100);
}

TEST(DrawInputs, QuaternionsHaveLengthOneAndSinesAreOfOneAngle) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto q = sample.argument("q", 4, 1);
  const auto s = sample.argument("sin_q", 5, 1);
  const auto c = sample.argument("cos_q", 5, 1);
  sample.domain.sizes["q"].push_back(3);
  sample.domain.quaternions = {{Quantity::q, 0}};
  sample.result({q[0] * q[1] * q[2] * q[3] * s[4] * c[4]});
  const bounds::InputSpace space(sample.program.graph, sample.domain);
  ASSERT_FALSE(space.missing());
  treeline::Rng rng(5);
  std::vector<bounds::States> inputs;
  for (int i = 0; i < 20; ++i) {
    space.put(space.change(space.draw(rng), rng), 3, inputs);
    double norm = 0;
    for (std::size_t k = 0; k < 4; ++k) norm += inputs[k][3] * inputs[k][3];
    EXPECT_NEAR(norm, 1, 1e-15);
    const auto& names = sample.program.graph.inputs();
    const auto at = [&](const char* name) {
      return inputs[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                             names.begin())][3];
    };
    EXPECT_NEAR(std::hypot(at("sin_q[4]"), at("cos_q[4]")), 1, 1e-15);
  }
}

/// 1 / q, with q uniform in -1 .. 1, has an error of 1 / |q|: more than 2, 10, 100 in 50, 10, 1 of
/// 100 states, that is, in 2048, 410, 41 of 4096 states with standard deviations 32, 19, 6. The
/// test allows four times that.
TEST(FindTypical, KnowsTheQuantiles) {
  Sample sample;
  const Graph::Scope scope(sample.program.graph);
  const auto q = sample.argument("q", 1, 1);
  sample.result({Expression(1.0) / q[0]});
  SearchEffort effort;
  effort.batches = 512;
  const auto typical = bounds::find_typical(sample.program, sample.domain, kUnit, effort);
  EXPECT_NEAR(typical[0][0].error, 2, 0.2);
  EXPECT_NEAR(typical[0][1].error, 10, 2);
  EXPECT_NEAR(typical[0][2].error, 100, 60);
}

/// Checks that the stated bound covers a search of other states with more effort, and hill
/// climbing. Returns the stated bound divided by the worst error found.
double search_longer(const GeneratedFunction& generated, const Domain& domain,
                     const SearchEffort& effort, int steps) {
  const auto longer = bounds::search_worst(generated.program, domain, kUnit, effort);
  HillClimber climber(generated.program, domain, effort.seed);
  double worst = 0, stated = 0;
  std::size_t first = 0;
  for (std::size_t r = 0; r < longer.size(); ++r) {
    const double bound = generated.rounding.worst[r].error;
    EXPECT_GE(bound, longer[r].error * kUnit) << generated.program.name;
    climber.hill_climb(first + longer[r].entry, steps);
    for (std::size_t i = 0; i < generated.program.results[r].values.size(); ++i) {
      EXPECT_LE(climber.worst[first + i], bound) << generated.program.name << " entry " << i;
      worst = std::max(worst, climber.worst[first + i]);
    }
    stated = std::max(stated, bound);
    first += generated.program.results[r].values.size();
  }
  return stated / worst;
}

/// Stated bound over the worst error found for forward dynamics and Lambda^-1: puma560 5.5, 16;
/// samm 6.2, 22; ur10e 18, 21; humanoid24 18, 30. A factor of four is the margin; the rest is due
/// to roundings that do not all have the same sign.
TEST(SearchWorst, StatedBoundsOfOurRobotsHold) {
  constexpr double kTight = 100;
  for (const char* name : {"puma560", "samm", "ur10e", "humanoid24"}) {
    const Subjects made =
        load_functions(name, {Function::forward_dynamics, Function::lambda_inverse});
    const bool large = made.robot.joints.size() > 20;
    const SearchEffort effort{32, 4, large ? 300 : 1000, 7};
    for (const GeneratedFunction& generated : made.generation.functions) {
      ASSERT_EQ(generated.rounding.kind, RoundingBound::Kind::searched);
      const double ratio =
          search_longer(generated, made.generation.domain, effort, large ? 500 : 4000);
      EXPECT_LE(ratio, kTight) << name << " " << generated.program.name;
      std::printf("%s %s: stated / worst found %.1f\n", name, generated.program.name.c_str(),
                  ratio);
    }
  }
}

TEST(SearchWorst, StatedBoundsOfRandomMechanismsHold) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RandomOptions options;
    options.joints = 6;
    options.floating_base = seed % 2 == 0;
    options.mimic = seed % 3 == 0 ? 0.3 : 0;
    const Subjects made =
        draw_functions(seed, options, {Function::forward_dynamics, Function::lambda_inverse});
    for (const GeneratedFunction& generated : made.generation.functions) {
      if (generated.rounding.kind != RoundingBound::Kind::searched) continue;  // no division left
      search_longer(generated, made.generation.domain, {32, 4, 300, seed}, 200);
    }
  }
}

/// First-order bound of each entry at one state.
std::vector<double> bounds_at(const Program& program, const HillClimber::Inputs& arguments) {
  bounds::ErrorPropagation errors(program.graph, kUnit);
  std::vector<bounds::States> inputs;
  for (const InputPlace& place : locate_inputs(program)) {
    inputs.emplace_back().fill(arguments[place.argument][place.element]);
  }
  errors.evaluate(inputs);
  std::vector<double> bounds;
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      bounds.push_back(errors.bound(value.node())[0] * kUnit);
    }
  }
  return bounds;
}

/// Near singularities errors grow without bound, and so does the bound of a state. Hill climbing
/// finds the largest errors, which are compared with the bound at the same state as long as
/// second-order terms are at most a thousandth of it.
TEST(FindTypical, BoundsHoldAtTheStatesClimbedTo) {
  constexpr double kSecondOrder = 1e-3;
  for (const char* name : {"puma560", "samm", "ur10e"}) {
    const Subjects made = load_functions(name, {Function::lambda, Function::control_torque});
    for (const GeneratedFunction& generated : made.generation.functions) {
      ASSERT_EQ(generated.rounding.kind, RoundingBound::Kind::typical);
      const Program& program = generated.program;
      HillClimber climber(program, made.generation.domain, 3);
      double nearest = 0;
      for (std::size_t i = 0; i < climber.worst.size(); i += 5) {
        for (const int steps : {10, 100, 1000}) {
          climber.hill_climb(i, steps);
          if (climber.at[i].empty()) continue;
          const std::vector<double> bounds = bounds_at(program, climber.at[i]);
          double size = 0;
          const auto results = evaluate<double>(program, climber.at[i]);
          for (const double x : results[0]) size = std::max(size, std::abs(x));
          if (!std::isfinite(size) || !(bounds[i] < kSecondOrder * size)) continue;
          EXPECT_LE(climber.worst[i], bounds[i] * (1 + kSecondOrder))
              << name << " " << program.name << " entry " << i;
          nearest = std::max(nearest, climber.worst[i] / bounds[i]);
        }
      }
      EXPECT_GT(nearest, 0.1) << name << " " << program.name;
    }
  }
}

}  // namespace
}  // namespace treeline::tests
