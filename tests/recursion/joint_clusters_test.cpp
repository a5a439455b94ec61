#include "recursion/methods/joint_clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "mechanism/build_mechanism.hpp"
#include "passes/count_operations.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"
#include "recursion/template_results.hpp"

// Robots whose followers are neighbours of their leaders, as fingers, parallel jaws and lifts have
// them. Would catch: a cluster that is taken for one joint of the wrong link, a follower's share
// that is lost, counted twice or has the wrong ratio, and a rotor in a cluster that is not felt.
namespace treeline::tests {
namespace {

/// Makes joints follow the joint before them or one beside them, in chains and stars.
void add_neighbours(Rng& rng, Robot& robot) {
  const std::size_t count = robot.joints.size();
  for (std::size_t i = 0; i < count; ++i) {
    Joint& joint = robot.joints[i];
    if (!detail::has_one_degree(joint) || !rng.chance(0.7)) continue;
    for (std::size_t j = 0; j < i; ++j) {
      const Joint& other = robot.joints[j];
      const bool is_neighbour = other.child == joint.parent || other.parent == joint.parent;
      if (!is_neighbour || !detail::has_one_degree(other)) continue;
      const int leader = other.mimic ? other.mimic->joint : static_cast<int>(j);
      joint.mimic = Mimic{leader, rng.rounded(-2, 2), rng.rounded(-0.5, 0.5)};
      break;
    }
  }
}

RandomMechanism hand(std::uint64_t seed) {
  RandomOptions options;
  options.joints = 9;
  options.branching = 0.4;
  options.mix = {4, 1, 2, 0.5, 0, 0, 0};
  options.operational_points = 2;
  options.external_forces = 1;
  options.floating_base = seed % 2 == 0;
  options.drives = 0.3;
  RandomMechanism made = random_mechanism(seed, options);
  Rng rng(seed);
  add_neighbours(rng, made.robot);
  return made;
}

TEST(JointClusters, AreOneJointOfTheLinkThatCarriesThem) {
  // 0 - 1 (follows 0) - 2; beside 0 at the world 3, which follows 0 too.
  Tree<double> tree;
  tree.nv = 2;
  const auto add = [&tree](int parent, int velocity) {
    TreeLink<double>& link = tree.links.emplace_back();
    link.kind = JointKind::revolute;
    link.parent = parent;
    link.v_index = velocity;
  };
  add(-1, 0);
  add(0, 0);
  add(1, 1);
  add(-1, 0);
  const auto clusters = find_clusters(tree);
  ASSERT_TRUE(clusters);
  EXPECT_EQ((*clusters)[0].joints, 3);
  EXPECT_EQ((*clusters)[0].first, 0);
  EXPECT_EQ((*clusters)[0].anchor, -1);
  EXPECT_EQ((*clusters)[1].joints, 1);
  EXPECT_EQ((*clusters)[1].anchor, 1);
  add(2, 0);  // behind the joint of another coordinate
  EXPECT_FALSE(find_clusters(tree));
}

// In 50 digits with unrounded constants only the formulas can differ.
TEST(JointClusters, AgreeWithTheInterpreterInFiftyDigits) {
  int robots = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = hand(seed);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    Rng rng(seed);
    const Inputs<Digits50> in = oracle.random_inputs(rng, 5);
    const Yardstick size = yardstick(oracle, in);
    const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
    if (!mechanism.has_mimics() || !find_clusters(tree_of<Digits50>(mechanism))) continue;
    ++robots;
    const TemplateRun<Digits50> run(mechanism, in);
    for (const Function function : {Function::forward_dynamics, Function::lambda_inverse,
                                    Function::lambda, Function::control_torque}) {
      if (!permits(function, oracle.has_points(), size)) continue;
      const auto expected = oracle.results(function, in);
      const auto runs = run.results(function);
      EXPECT_GE(runs.size(), 2u) << function_name(function);
      for (const auto& [route, results] : runs) {
        const double error =
            relative_error(results, expected, size.least_scale(function)) / size.growth(function);
        EXPECT_LE(error, 1e-41) << function_name(function) << " " << route;
      }
    }
  }
  EXPECT_GE(robots, 20);
}

// A follower saves work: it has one freedom less than the same robot whose joints are all free.
TEST(JointClusters, CostLessThanFreeJoints) {
  const RandomMechanism made = hand(2);
  Robot free = made.robot;
  for (Joint& joint : free.joints) joint.mimic.reset();
  const auto least = [&](const Robot& robot) {
    int flops = std::numeric_limits<int>::max();
    const Mechanism mechanism = reduced_mechanism(robot, made.scene);
    for (const Program& program : trace_function(mechanism, Function::forward_dynamics)) {
      flops = std::min(flops, count_operations(program).flops());
    }
    return flops;
  };
  ASSERT_TRUE(reduced_mechanism(made.robot, made.scene).has_mimics());
  EXPECT_LT(least(made.robot), least(free));
}

}  // namespace
}  // namespace treeline::tests
