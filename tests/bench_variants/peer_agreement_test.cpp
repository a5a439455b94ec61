#include <gtest/gtest.h>

#include <algorithm>

#include "bench/bench.hpp"
#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

// Results of independent libraries, compared with 50 digits. Would catch: an adapter that gives its
// library another robot, order of joints, gravity or axes, states of a floating base in which a
// peer cannot be right to the last digits, and rows that are held elsewhere or at other states.

namespace treeline::tests {
namespace {

std::optional<BenchReport> bench(const std::string& urdf, const std::string& scene_file,
                                 const std::vector<Function>& functions) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  if (!robot) return std::nullopt;
  auto scene = read_scene(scene_file, *robot, diagnostics);
  if (!scene) return std::nullopt;
  scene->functions = functions;
  BenchOptions options;
  options.states = 12;
  options.flags = "-O0";
  options.timing = {1, 1};
  options.peers = find_peers({TREELINE_PEER_FILES}, diagnostics);
  return run_bench(*robot, *scene, options, diagnostics);
}

void expect_digits(const std::string& name, const std::vector<Function>& functions) {
  const std::string folder = std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/";
  const auto report = bench(folder + name + ".urdf", folder + "scene.yaml", functions);
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

bool begins(const BenchRow& row, const std::string& name) {
  return row.variant.name.starts_with(name);
}

enum class Rows { independent, dependent };

/// With rows held, Pinocchio must have the motion to its last digits. Its plain solve divides by
/// what vanishes where rows depend on each other. DART's steps have an error of their length,
/// and another one of its solver for impulses, by which some are left out.
void expect_held(const std::string& robot, const std::string& urdf, Rows rows) {
  const auto report = bench(urdf, std::string(TREELINE_HELD_DIR) + "/" + robot + ".yaml",
                            {Function::constrained_forward_dynamics});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->no_peers, "");
  const BenchFunction& made = report->functions.at(0);
  EXPECT_EQ(made.states + made.singular, 12);
  EXPECT_GT(made.states, 4);
  for (const BenchRow& row : made.disagreeing) {
    const bool divides_by_zero = rows == Rows::dependent && begins(row, "Pinocchio");
    const bool is_inexact = begins(row, "DART") && row.norm.median < 1e-3;
    EXPECT_TRUE(divides_by_zero || is_inexact) << row.variant.name << ' ' << row.norm.median;
  }
  int by_pinocchio = 0;
  for (const BenchRow& row : made.rows) {
    if (row.variant.group != VariantGroup::peer || !begins(row, "Pinocchio")) continue;
    ++by_pinocchio;
    EXPECT_LT(row.norm.worst, 1e-10) << row.variant.name;
  }
  const bool has_pinocchio =
      std::any_of(report->peers.begin(), report->peers.end(),
                  [](const BenchPeer& peer) { return peer.name == "Pinocchio"; });
  if (has_pinocchio) {
    EXPECT_GE(by_pinocchio, rows == Rows::dependent ? 1 : 2);
  }
}

TEST(PeerAgreement, OfAFourBarInThePlane) {
  expect_held("four_bar", data_file("written/four_bar.urdf"), Rows::dependent);
}

TEST(PeerAgreement, OfAFourBarInSpace) {
  expect_held("spatial_four_bar", data_file("written/spatial_four_bar.urdf"), Rows::independent);
}

TEST(PeerAgreement, OfADelta) {
  expect_held("delta", data_file("written/delta.urdf"), Rows::independent);
}

TEST(PeerAgreement, OfAQuadrupedOnItsFeet) {
  expect_held("anymal", data_file("golden/anymal.urdf"), Rows::independent);
}

TEST(PeerAgreement, OfAHumanoidOnTwoSoles) {
  expect_held("humanoid24", std::string(TREELINE_ROBOTS_DIR) + "/humanoid24/humanoid24.urdf",
              Rows::dependent);
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
