#include "hit_wall.hpp"

#include <gtest/gtest.h>

#include <string>

// The humanoid's fist against a wall on generated code. Would catch: impulses or effective masses
// that disagree with the contact-space inverse inertia, joints that swing before the blow, a hand
// that sinks into the wall, and a pressing force that differs from the one commanded in operational
// space.

namespace treeline::experiments {
namespace {

Plan plan() {
  Plan read;
  std::string error;
  EXPECT_TRUE(
      read_plan(std::string(TREELINE_ROBOTS_DIR) + "/humanoid24/hit_wall.yaml", read, error, ""))
      << error;
  return read;
}

class HitWall : public testing::TestWithParam<std::pair<double, double>> {};

INSTANTIATE_TEST_SUITE_P(RestitutionAndFriction, HitWall,
                         testing::Values(std::pair{0.0, 0.4}, std::pair{0.5, 0.0},
                                         std::pair{0.5, 0.4}, std::pair{0.8, 0.4}));

TEST_P(HitWall, KeepsItsClaims) {
  WallSettings settings;
  settings.restitution = GetParam().first;
  settings.friction = GetParam().second;
  const WallRun run = run_hit_wall(plan(), settings);
  EXPECT_TRUE(hit_wall_claims_hold(run, settings)) << hit_wall_summary(run, settings);
}

TEST(HitWallOnce, WithoutLossKeepsItsEnergyInTheFirstBlow) {
  WallSettings settings;
  settings.restitution = 1;
  settings.friction = 0;
  const WallRun run = run_hit_wall(plan(), settings);
  ASSERT_FALSE(run.blows.empty());
  EXPECT_NEAR(run.blows[0].energy, 0, 1e-12);
  EXPECT_NEAR(run.blows[0].parting, run.blows[0].approach, 1e-12);
}

}  // namespace
}  // namespace treeline::experiments
