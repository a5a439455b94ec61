#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "choice/function_mechanisms.hpp"
#include "choice/generated_function.hpp"
#include "choice/only_by_name.hpp"
#include "limbed_robot.hpp"
#include "mechanism/find_limbs.hpp"
#include "passes/passes.hpp"
#include "random_mechanism.hpp"
#include "recursion/routes/trace_function.hpp"

// The route that is emitted. Would catch: a cheaper one that is pruned, as traced or for its limbs,
// before passes and lanes make it so; a choice by another cost than the one that is stated and
// printed; and weights by which a route wins that takes an eighth longer.

namespace treeline {
namespace {

constexpr Function kCompeting[] = {Function::lambda_inverse, Function::lambda,
                                   Function::control_torque, Function::forward_dynamics};
/// Share by which a rejected route may be cheaper: finishing all of them would take the most of the
/// generator's time.
constexpr double kCheaper = 0.02;

Scene scene_for(const Scene& scene, Function function, int lanes) {
  Scene one = scene;
  one.functions = {function};
  one.lanes = lanes;
  return one;
}

/// Least cost of all routes, each finished as for emission, alike limbs in lanes or not.
Cost find_least(const Mechanism& mechanism, Function function, const RouteOptions& options) {
  Cost least{{}, {}, std::numeric_limits<double>::infinity()};
  Mechanism with_limbs = mechanism;
  with_limbs.limbs = find_limbs(mechanism, options.lanes);
  for (const Mechanism* tried : {&mechanism, &std::as_const(with_limbs)}) {
    if (tried == &with_limbs && with_limbs.limbs.empty()) continue;
    for (Program& program : trace_function(*tried, function, options.lanes)) {
      if (is_only_by_name(program)) continue;
      std::vector<PassReport> log;
      const Cost cost = cost_of(reduce_operations(std::move(program), log), options.costs);
      if (cost.weighted < least.weighted) least = cost;
    }
  }
  return least;
}

tests::RandomOptions options_of(int joints, double branching, int points, bool floating) {
  tests::RandomOptions options;
  options.joints = joints;
  options.branching = branching;
  options.operational_points = points;
  options.floating_base = floating;
  return options;
}

class Cheapest : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Lanes, Cheapest, testing::Values(1, 4, 8),
                         testing::PrintToStringParamName());

TEST_P(Cheapest, IsNoRejectedRoute) {
  double worst = 0;
  std::uint64_t seed = 100;
  for (const tests::RandomOptions& options :
       {options_of(4, 0, 1, false), options_of(7, 0, 1, false), options_of(10, 0, 1, false),
        options_of(10, 0.3, 2, false), options_of(12, 0.2, 1, true), options_of(16, 0.5, 3, false),
        options_of(20, 0.1, 2, true)}) {
    const tests::RandomMechanism made = tests::random_mechanism(++seed, options);
    for (const Function function : kCompeting) {
      SCOPED_TRACE(fmt::format("seed {}, {}", seed, function_name(function)));
      const Scene scene = scene_for(made.scene, function, GetParam());
      FunctionMechanisms mechanisms(made.robot, scene);
      const Mechanism& mechanism = mechanisms.of(function);
      const RouteOptions asked = route_options(scene);
      const GeneratedFunction emitted = generate_function(mechanism, function, asked);
      EXPECT_DOUBLE_EQ(cost_of(emitted.program, asked.costs).weighted, emitted.chosen.weighted);
      const Cost least = find_least(mechanism, function, asked);
      const double share = 1 - least.weighted / emitted.chosen.weighted;
      EXPECT_LE(share, kCheaper) << describe(least.route) << " costs " << least.weighted << ", "
                                 << describe(emitted.chosen.route) << ", which is emitted, "
                                 << emitted.chosen.weighted;
      worst = std::max(worst, share);
    }
  }
  std::cout << GetParam() << " lanes: a rejected route is cheaper by " << worst * 100 << " %\n";
}

/// An algorithm that was measured to be faster than the one that was chosen before.
struct Measured {
  tests::LimbedShape shape;
  Function function;
  int lanes;
  const char* faster;
  const char* slower;
  double share;  ///< of the slower one's time, g++ 12 -O3 -march=native on an AMD EPYC (Zen 5)
};

constexpr Measured kMeasured[] = {
    {{16, 0, 0, 1}, Function::control_torque, 1, "fused/branching", "fused/pv-osim", 0.87},
    {{5, 2, 8, 1}, Function::control_torque, 1, "fused/branching", "fused/pv-osim", 0.91},
    {{5, 4, 10, 1}, Function::control_torque, 1, "fused/branching", "fused/pv-osim", 0.93},
    {{10, 0, 0, 1}, Function::lambda, 8, "pv-osim", "ltdl-poses", 0.91},
};

TEST(Cost, IsLessWhereARouteWasMeasuredToBeFaster) {
  for (const Measured& row : kMeasured) {
    const tests::LimbedRobot made = tests::make_limbed_robot(row.shape);
    const Scene scene = scene_for(made.scene, row.function, row.lanes);
    FunctionMechanisms mechanisms(made.robot, scene);
    const GeneratedFunction emitted =
        generate_function(mechanisms.of(row.function), row.function, route_options(scene));
    EXPECT_EQ(emitted.chosen.route.algorithm, row.faster)
        << fmt::format("{} + {} x {} hinges: {} takes {} of the time", row.shape.trunk,
                       row.shape.limbs, row.shape.limb_links, row.faster, row.share);
    EXPECT_TRUE(
        std::any_of(emitted.rejected.begin(), emitted.rejected.end(),
                    [&](const Cost& other) { return other.route.algorithm == row.slower; }));
  }
}

// The formula as docs/explanation/algorithms.md states it, on scalar code.
TEST(Cost, IsTheOneThatIsStated) {
  const tests::LimbedRobot made = tests::make_limbed_robot({7, 0, 0, 1});
  const Scene scene = scene_for(made.scene, Function::control_torque, 1);
  FunctionMechanisms mechanisms(made.robot, scene);
  const GeneratedFunction emitted = generate_function(
      mechanisms.of(Function::control_torque), Function::control_torque, route_options(scene));
  const OperationCount& count = emitted.chosen.count;
  const double operations = count.add + count.mul + 8 * count.div + 12 * count.sin_cos;
  const double chain = 2 * critical_path(emitted.program);
  EXPECT_NEAR(emitted.chosen.weighted, std::pow(std::pow(operations, 4) + std::pow(chain, 4), 0.25),
              1e-9 * operations);
}

}  // namespace
}  // namespace treeline
