#include <gtest/gtest.h>

#include "bench/bench.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

// Results of independent libraries, compared with 50 digits. Would catch: an adapter that gives its
// library another robot, order of joints, gravity or axes, and states of a floating base in which a
// peer cannot be right to the last digits.

namespace treeline::tests {
namespace {

void expect_digits(const std::string& name, std::vector<Function> functions) {
  const std::string folder = std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/";
  Diagnostics diagnostics;
  const auto robot = read_urdf(folder + name + ".urdf", diagnostics);
  ASSERT_TRUE(robot);
  auto scene = read_scene(folder + "scene.yaml", *robot, diagnostics);
  ASSERT_TRUE(scene);
  scene->functions = std::move(functions);
  BenchOptions options;
  options.states = 12;
  options.flags = "-O0";
  options.timing = {1, 1};
  options.peers = find_peers({TREELINE_PEER_FILES}, diagnostics);
  const auto report = run_bench(*robot, *scene, options, diagnostics);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->no_peers, "");
  int measured = 0;
  for (const BenchFunction& made : report->functions) {
    for (const BenchRow& row : made.disagreeing) ADD_FAILURE() << row.variant.name;
    for (const BenchRow& row : made.rows) {
      if (row.variant.group != VariantGroup::peer) continue;
      ++measured;
      // Rounding of recursions in world axes, with condition numbers of a thousand and more.
      EXPECT_LT(row.norm.worst, 1e-10) << row.variant.name << ' ' << function_name(made.function);
    }
  }
  EXPECT_GT(measured, 0);
}

TEST(PeerAgreement, OfASerialRobot) {
  expect_digits("puma560",
                {Function::gravity, Function::nonlinear_effects, Function::inverse_dynamics,
                 Function::mass_matrix, Function::forward_dynamics, Function::lambda_inverse});
}

TEST(PeerAgreement, OfATree) {
  expect_digits("humanoid24", {Function::inverse_dynamics, Function::mass_matrix});
}

TEST(PeerAgreement, OfAFloatingBase) {
  expect_digits("tumbler", {Function::inverse_dynamics, Function::mass_matrix});
}

}  // namespace
}  // namespace treeline::tests
