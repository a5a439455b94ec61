#include <gtest/gtest.h>

#include <limits>

#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/read_robots.hpp"
#include "recursion/template_results.hpp"

// The routes to Lambda^-1 and to the control torque in their most difficult cases: points that
// share links and paths, floating bases, spherical wrists. Would catch: a wrong nearest common
// ancestor, a route that is offered where it does not apply or missing where it does, and a
// rotation about the wrong axis.

namespace treeline::tests {
namespace {

RandomOptions chain_of(int joints, double branching, bool floating) {
  RandomOptions options;
  options.joints = joints;
  options.branching = branching;
  options.mix = {5, 1, 2, 0, 0, 0.3};
  options.floating_base = floating;
  options.operational_points = 1;
  return options;
}

/// Whether some traced route of the function has this name.
bool offers(const RandomMechanism& made, Function function, const std::string& name) {
  for (const Program& program :
       trace_function(reduced_mechanism(made.robot, made.scene), function)) {
    if (describe(program.route).find(name) != std::string::npos) return true;
  }
  return false;
}

/// Compares every route of the three functions that contain Lambda^-1, in 50 digits. Returns the
/// number of routes.
int expect_routes_agree(const RandomMechanism& made, std::uint64_t seed) {
  Rng rng(seed);
  const Oracle<Digits50> oracle(made.robot, made.scene);
  const Inputs<Digits50> in = oracle.random_inputs(rng);
  const Yardstick size = yardstick(oracle, in);
  const TemplateRun<Digits50> run(reduced_mechanism(made.robot, made.scene), in);
  int count = 0;
  for (const Function function :
       {Function::lambda_inverse, Function::lambda, Function::control_torque}) {
    if (!permits(function, oracle.has_points(), size)) continue;
    const auto expected = oracle.results(function, in);
    for (const auto& [route, results] : run.results(function)) {
      const double error =
          relative_error(results, expected, size.least_scale(function)) / size.growth(function);
      EXPECT_LE(error, 1e-41) << function_name(function) << " " << route;
      ++count;
    }
  }
  return count;
}

TEST(LambdaRoutes, AgreeOnPointsThatShareLinksAndPaths) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomMechanism made = random_mechanism(seed, chain_of(9, 0.3, seed % 2 == 0));
    Rng rng(seed + 50);
    made.scene.operational_points.clear();
    const auto add = [&](int link, bool all_rows) {
      ScenePoint point;
      point.name = "point_" + std::to_string(made.scene.operational_points.size());
      point.link = made.robot.links[static_cast<std::size_t>(link)].name;
      point.origin = detail::random_pose(rng, 0.3, 0.3);
      point.axes = seed % 3 == 0 ? Axes::local : Axes::world;
      if (!all_rows) detail::drop_rows(rng, point);
      made.scene.operational_points.push_back(point);
    };
    for (const int link : {9, 9, 8, 6, 3, 0}) add(link, seed % 4 < 2);
    EXPECT_GE(expect_routes_agree(made, seed), 3);
  }
}

TEST(LambdaRoutes, AgreeOnOnePointOfARobotThatFloats) {
  for (std::uint64_t seed = 21; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = random_mechanism(seed, chain_of(7, seed % 2 == 0 ? 0.4 : 0, true));
    EXPECT_TRUE(offers(made, Function::lambda_inverse, "table 5.1"));
    EXPECT_TRUE(offers(made, Function::control_torque, "table 5.1"));
    EXPECT_GE(expect_routes_agree(made, seed), 10);
  }
}

// All routes are offered beyond ball joints, in the axes of any link.
TEST(LambdaRoutes, AgreeBeyondBallJoints) {
  for (std::uint64_t seed = 31; seed <= 36; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options = chain_of(5, seed % 3 == 0 ? 0.4 : 0, seed % 2 == 0);
    options.mix = {2, 0, 1, 0, 0, 0, 4};
    const RandomMechanism made = random_mechanism(seed, options);
    EXPECT_EQ(offers(made, Function::lambda_inverse, "table 5.1"), options.floating_base);
    EXPECT_TRUE(offers(made, Function::lambda_inverse, "table 5.3"));
    EXPECT_GE(expect_routes_agree(made, seed), 10);
  }
}

TEST(LambdaRoutes, AreOfferedWhereTheyApply) {
  const RandomMechanism fixed = random_mechanism(3, chain_of(6, 0, false));
  for (const char* name : {"PV-OSIM", "L^T D L", "table 5.3", "axes of link 1"}) {
    EXPECT_TRUE(offers(fixed, Function::lambda_inverse, name)) << name;
  }
  EXPECT_FALSE(offers(fixed, Function::lambda_inverse, "table 5.1"));  // a big base loses digits
  RandomOptions options = chain_of(9, 0.3, true);
  options.mimic = 0.9;
  const RandomMechanism mimics = random_mechanism(4, options);
  ASSERT_TRUE(reduced_mechanism(mimics.robot, mimics.scene).has_mimics());
  for (const char* name : {"PV-OSIM", "table 5"}) {
    EXPECT_FALSE(offers(mimics, Function::lambda_inverse, name)) << name;
  }
  EXPECT_TRUE(offers(mimics, Function::lambda_inverse, "L^T D L"));
}

/// Six hinges in a row; the axes of the last three intersect in one point.
RandomMechanism arm_with_spherical_wrist(std::uint64_t seed) {
  RandomOptions options = chain_of(6, 0, false);
  options.mix = {1, 0, 0, 0, 0, 0};
  options.aligned = 0.3;
  options.external_forces = 1;
  RandomMechanism made = random_mechanism(seed, options);
  for (Joint& joint : made.robot.joints) {
    if (joint.child >= 5) joint.origin.xyz = {};
  }
  made.scene.operational_points.front().link = "link_5";
  return made;
}

// With six joints and six rows the control torque does not need Lambda. Near a singular pose, where
// Lambda is large, only J's own condition number affects the short way.
TEST(ResolvedAcceleration, IsTheControlTorqueOfAnArmWithASphericalWrist) {
  ErrorTable table;
  int offered = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = arm_with_spherical_wrist(seed);
    if (!offers(made, Function::control_torque, "resolved acceleration")) continue;
    ++offered;
    expect_routes_agree(made, seed);
    Rng rng(seed + 400);
    const CheckedPrograms programs(made.robot, made.scene);
    programs.compare<double>(programs.oracle().random_inputs(rng), table);
  }
  EXPECT_GE(offered, 6);
  table.expect_below(kUlpBound);
  EXPECT_FALSE(offers(random_mechanism(3, chain_of(6, 0, false)), Function::control_torque,
                      "resolved acceleration"));
}

// Counts do not vary. These are the savings of the routes for arms, with all rows of one point in
// world axes.
TEST(LambdaRoutes, KeepTheCountsOfArmsLow) {
  const auto least = [](const char* name, Function function) {
    const GoldenRobot golden = read_golden(name);
    int flops = std::numeric_limits<int>::max();
    for (const Program& program :
         trace_function(reduced_mechanism(golden.robot, golden.scene), function)) {
      flops = std::min(flops, count_operations(canonicalize(program)).flops());
    }
    return flops;
  };
  EXPECT_LE(least("puma560", Function::lambda_inverse), 640);
  EXPECT_LE(least("ur5", Function::lambda_inverse), 600);
  EXPECT_LE(least("samm", Function::lambda_inverse), 1210);
  EXPECT_LE(least("puma560", Function::control_torque), 610);
}

}  // namespace
}  // namespace treeline::tests
