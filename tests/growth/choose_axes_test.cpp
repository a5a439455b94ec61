#include "choice/choose_axes.hpp"

#include <gtest/gtest.h>

#include "choice/function_mechanisms.hpp"
#include "mechanism/build_mechanism.hpp"
#include "passes/count_operations.hpp"
#include "random_mechanism.hpp"
#include "recursion/routes/trace_function.hpp"
#include "scenes_of_robots.hpp"

// Chosen axes make code shorter: never longer as traced, and shorter by a tenth if axes are
// parallel. Would catch: a choice that is not used, and a choice made by the wrong count.

namespace treeline::growth {
namespace {

int inverse_dynamics_flops(const Mechanism& mechanism) {
  return count_operations(trace_function(mechanism, Function::inverse_dynamics).front()).flops();
}

TEST(ChosenAxes, ShortenInverseDynamics) {
  Diagnostics diagnostics;
  int with_parallel_axes = 0;
  for (const RobotInScene& each : scenes_of_robots(TREELINE_ROBOTS_DIR, diagnostics)) {
    FunctionMechanisms mechanisms(each.robot, each.scene);
    Mechanism plain = mechanisms.of(Function::inverse_dynamics);
    const int chosen = inverse_dynamics_flops(plain);
    for (MovingLink& link : plain.links) link.defers_rotation = link.carries_column = false;
    const int unchosen = inverse_dynamics_flops(plain);
    EXPECT_LE(chosen, unchosen) << each.scene.name;
    if (each.scene.name == "puma560") {
      EXPECT_LE(chosen, 285);
    }
    if (each.robot.name == "puma560" || each.robot.name == "ur10e") {
      EXPECT_LT(chosen, 0.9 * unchosen) << each.scene.name;
      ++with_parallel_axes;
    }
  }
  EXPECT_GE(with_parallel_axes, 2);
}

/// A chain so long that links at some distance decide at the same time.
TEST(ChosenAxes, ShortenLongChains) {
  tests::RandomOptions options;
  options.joints = 70;
  options.branching = 0;
  options.mix = {1, 0, 0, 0, 0, 0};
  options.aligned = 0.9;
  constexpr std::uint64_t kSeed = 3;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const tests::RandomMechanism drawn = tests::random_mechanism(kSeed, options);
  for (const Function function : {Function::inverse_dynamics, Function::forward_dynamics}) {
    Mechanism mechanism = reduced_mechanism(drawn.robot, drawn.scene);
    const int unchosen = count_cheapest(mechanism, function);
    choose_axes(mechanism, function);
    EXPECT_LT(count_cheapest(mechanism, function), 0.98 * unchosen) << function_name(function);
  }
}

}  // namespace
}  // namespace treeline::growth
