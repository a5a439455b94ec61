#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>

#include "mechanism/build_mechanism.hpp"
#include "passes/count_operations.hpp"
#include "recursion/least_flops.hpp"
#include "recursion/read_robots.hpp"
#include "recursion/routes/trace_function.hpp"

// Operation counts do not vary. Bounds for two robots; and what a scene does not need must not cost
// anything. Would catch: a reduction, a simplification or a cheap route that is lost.

namespace treeline::tests {
namespace {

Scene with_axes(Scene scene, Axes axes) {
  for (ScenePoint& point : scene.operational_points) point.axes = axes;
  return scene;
}

struct Bounds {
  const char* robot;
  int inverse_dynamics, lambda_inverse, control_torque;
};

std::ostream& operator<<(std::ostream& out, const Bounds& bounds) {
  return out << bounds.robot;
}

class Counts : public testing::TestWithParam<Bounds> {};

INSTANTIATE_TEST_SUITE_P(Robots, Counts,
                         testing::Values(Bounds{"puma560", 330, 700, 1250},
                                         Bounds{"humanoid24", 2600, 7700, 11500}),
                         [](const auto& tested) { return std::string(tested.param.robot); });

// Lambda^-1 in the point's axes or the world's, whichever are cheaper.
TEST_P(Counts, StayBelowTheirBounds) {
  const GoldenRobot golden = read_golden(GetParam().robot);
  const Scene world = with_axes(golden.scene, Axes::world);
  const Scene local = with_axes(golden.scene, Axes::local);
  const auto in_both = [&](Function function) {
    const std::pair counts{least_flops(golden.robot, world, function),
                           least_flops(golden.robot, local, function)};
    std::cout << GetParam().robot << " " << function_name(function) << ": " << counts.first
              << " flops in world axes, " << counts.second << " in local axes\n";
    return std::min(counts.first, counts.second);
  };
  EXPECT_LE(in_both(Function::inverse_dynamics), GetParam().inverse_dynamics);
  EXPECT_LE(in_both(Function::lambda_inverse), GetParam().lambda_inverse);
  EXPECT_LE(in_both(Function::control_torque), GetParam().control_torque);
  for (const Function function : kDefaultFunctions) in_both(function);
}

/// An arm whose wrist is not spherical.
RandomMechanism arm() {
  RandomOptions options;
  options.joints = 7;
  options.branching = 0;
  options.mix = {1, 0, 0, 0, 0, 0};
  RandomMechanism made = random_mechanism(5, options);
  made.scene.operational_points[0].link = "link_6";
  return made;
}

TEST(Specialised, NoGravityCostsLess) {
  RandomMechanism made = arm();
  made.scene.gravity = {0, 0, -9.81};
  Scene weightless = made.scene;
  weightless.gravity = {0, 0, 0};
  for (const Function function :
       {Function::inverse_dynamics, Function::nonlinear_effects, Function::forward_dynamics}) {
    EXPECT_LT(least_flops(made.robot, weightless, function),
              least_flops(made.robot, made.scene, function))
        << function_name(function);
  }
  EXPECT_EQ(least_flops(made.robot, weightless, Function::gravity), 0);
}

TEST(Specialised, FewerRowsCostLess) {
  RandomMechanism made = arm();
  made.scene.operational_points[0].rows = {true, true, true, true, true, true};
  Scene linear = made.scene;
  linear.operational_points[0].rows = {true, true, true, false, false, false};
  Scene one = made.scene;
  one.operational_points[0].rows = {false, false, true, false, false, false};
  for (const Function function :
       {Function::jacobian, Function::bias_acceleration, Function::lambda_inverse, Function::lambda,
        Function::control_torque}) {
    const int all = least_flops(made.robot, made.scene, function);
    const int three = least_flops(made.robot, linear, function);
    if (function != Function::jacobian) {  // whose angular rows are the joints' axes, needed anyway
      EXPECT_LT(three, all) << function_name(function);
    }
    EXPECT_LT(least_flops(made.robot, one, function), three) << function_name(function);
  }
}

TEST(Specialised, GravityAndMassMatrixKnowNoVelocities) {
  const RandomMechanism made = arm();
  const int all = least_flops(made.robot, made.scene, Function::inverse_dynamics);
  const int without_qdd = least_flops(made.robot, made.scene, Function::nonlinear_effects);
  EXPECT_LT(without_qdd, all);
  EXPECT_LT(least_flops(made.robot, made.scene, Function::gravity), without_qdd / 2);
}

// A point on the trunk is not carried through the branches beyond it, and a function of points does
// not depend on links beyond them.
TEST(Specialised, LinksBeyondThePointCostKinematicsNothing) {
  const RandomMechanism made = arm();
  Scene near = made.scene;
  near.operational_points[0].link = "link_2";
  for (const Function function :
       {Function::forward_kinematics, Function::jacobian, Function::bias_acceleration}) {
    EXPECT_LT(least_flops(made.robot, near, function),
              least_flops(made.robot, made.scene, function))
        << function_name(function);
  }
}

TEST(Specialised, AbsentExternalForcesCostNothing) {
  const RandomMechanism made = arm();
  Scene pushed = made.scene;
  pushed.external_forces = {made.scene.operational_points[0]};
  EXPECT_LT(least_flops(made.robot, made.scene, Function::inverse_dynamics),
            least_flops(made.robot, pushed, Function::inverse_dynamics));
  EXPECT_EQ(least_flops(made.robot, made.scene, Function::gravity),
            least_flops(made.robot, pushed, Function::gravity));
}

TEST(Specialised, ALockedJointCostsLessThanAMovingOne) {
  const RandomMechanism made = arm();
  Scene held = made.scene;
  held.locked["joint_3"] = 0.3;
  for (const Function function : {Function::inverse_dynamics, Function::mass_matrix,
                                  Function::forward_dynamics, Function::jacobian}) {
    EXPECT_LT(least_flops(made.robot, held, function),
              least_flops(made.robot, made.scene, function))
        << function_name(function);
  }
}

// Would catch: a law of singular tasks that takes more than its four products and a sum a row.
TEST(Specialised, ARowThatMayYieldCostsFiveOperations) {
  const std::vector<RobotInScene> robots = read_robots();
  const auto planar = std::find_if(robots.begin(), robots.end(), [](const RobotInScene& each) {
    return each.name.starts_with("planar3r");  // both of whose rows may yield
  });
  ASSERT_NE(planar, robots.end());
  Scene exact = planar->scene;
  exact.singular = SingularTasks::exact;
  for (const Function function : {Function::lambda, Function::control_torque}) {
    EXPECT_EQ(least_flops(planar->robot, planar->scene, function),
              least_flops(planar->robot, exact, function) + 2 * 5)
        << function_name(function);
  }
}

// Each step of reduction saves operations.
TEST(Specialised, EachReductionSaves) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    RandomOptions options;
    options.joints = 8;
    options.mix = {5, 1, 1, 1, 0, 0};
    const RandomMechanism made = random_mechanism(seed, options);
    Mechanism lumped = build_mechanism(made.robot, made.scene);
    Mechanism regrouped = lumped;
    regroup_inertias(regrouped);
    const Mechanism placed = reduced_mechanism(made.robot, made.scene);
    const auto count = [](const Mechanism& mechanism) {
      return count_operations(trace_function(mechanism, Function::inverse_dynamics)[0]).flops();
    };
    EXPECT_LT(count(regrouped), count(lumped)) << "seed " << seed;
    EXPECT_LE(count(placed), count(regrouped)) << "seed " << seed;
  }
}

// There are several routes, each with its own name, and none of them is traced without need.
TEST(Routes, AreSeveralAndNamed) {
  const RandomMechanism made = arm();
  const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
  for (const Function function :
       {Function::lambda_inverse, Function::lambda, Function::control_torque}) {
    std::vector<std::string> names;
    for (const Program& program : trace_function(mechanism, function)) {
      names.push_back(describe(program.route));
    }
    EXPECT_GE(names.size(), 2U);
    std::sort(names.begin(), names.end());
    EXPECT_TRUE(std::adjacent_find(names.begin(), names.end()) == names.end());
  }
}

// The same mechanism gives the same nodes in the same order.
TEST(Routes, AreTracedTheSameEveryTime) {
  const RandomMechanism made = arm();
  const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
  for (const Function function : kDefaultFunctions) {
    const auto one = trace_function(mechanism, function);
    const auto other = trace_function(reduced_mechanism(made.robot, made.scene), function);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      const auto& nodes = one[k].graph.nodes();
      const auto& same = other[k].graph.nodes();
      ASSERT_EQ(nodes.size(), same.size()) << describe(one[k].route);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        ASSERT_TRUE(nodes[i].op == same[i].op && nodes[i].a == same[i].a &&
                    nodes[i].b == same[i].b && nodes[i].value == same[i].value);
      }
    }
  }
}

}  // namespace
}  // namespace treeline::tests
