// The box experiment on its generated code: the claims of Chang fig. 7.9 and 7.10 and of the
// virtual linkage. Would catch: generated control and dynamics of closed chains that do not fit
// each other, a squeeze that is not the commanded one or moves the box, and grasps that drift
// apart.
#include "put_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "humanoid24_box.hpp"
#include "servo/clock.hpp"

namespace {

using namespace treeline::experiments;  // NOLINT: all of it is under test

struct Generated {
  static constexpr int kCoordinates = humanoid24_box::kCoordinates;
  static constexpr int kVelocities = humanoid24_box::kVelocities;
  static constexpr auto& mass_matrix = humanoid24_box::mass_matrix;
  static constexpr auto& object_state = humanoid24_box::object_state;
  static constexpr auto& object_control_torque = humanoid24_box::object_control_torque;
  static constexpr auto& object_forward_dynamics = humanoid24_box::object_forward_dynamics;
};
using Humanoid24WithBox = RobotWithObject<Generated>;

const std::string kFolder = TREELINE_ROBOTS_DIR "/humanoid24/";

BoxPlan the_plan() {
  BoxPlan plan;
  std::string error;
  EXPECT_TRUE(read_box_plan(kFolder + "put_box.yaml", plan, error)) << error;
  return plan;
}

BoxOutcome run(const BoxPlan& plan) {
  JointLimits limits;
  std::string error;
  EXPECT_TRUE(read_limits(kFolder + "humanoid24.urdf", plan.run.joints, limits, error)) << error;
  treeline::servo::SimulatedClock clock;
  RunSettings settings;
  settings.substeps = 1;
  return put_box<Humanoid24WithBox>(plan, settings, limits, clock);
}

TEST(PutBox, ArrivesOnTheFloorSqueezedAsCommanded) {
  const BoxPlan plan = the_plan();
  const BoxOutcome outcome = run(plan);
  EXPECT_FALSE(outcome.fault);  // joints, velocities and torques stay within the URDF's limits
  EXPECT_LT(outcome.initial_gap, 1e-14);
  const auto& table = outcome.table;
  ASSERT_EQ(table.rows(), 9251U);
  ASSERT_EQ(table.columns(), box_table_names(plan.run.joints).size());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(table.at(table.rows() - 1, 4 + i), plan.run.target[i], 1e-6);
  }
  const BoxErrors errors = largest_box_errors(outcome, plan);
  EXPECT_TRUE(box_within_bounds(errors)) << box_summary(outcome, plan);
  EXPECT_TRUE(box_rests(errors)) << box_summary(outcome, plan);
  EXPECT_LT(errors.rotation, 1e-4);
}

// A squeeze does no work: with 30 N, none, and a twist the motion is the same, joint by joint.
TEST(PutBox, InternalForcesMoveNothing) {
  BoxPlan plan = the_plan();
  plan.run.duration = 1.5;
  plan.run.settle = 0.1;
  plan.run.target = {0.45, 0.02, 0.9};
  const BoxOutcome squeezed = run(plan);
  plan.internal = {5, 1, -0.5, 0.3, 0.2, -0.4};
  const BoxOutcome twisted = run(plan);
  ASSERT_EQ(squeezed.table.rows(), twisted.table.rows());
  EXPECT_TRUE(box_within_bounds(largest_box_errors(twisted, plan))) << box_summary(twisted, plan);
  double away = 0.0;
  for (std::size_t i = 0; i < plan.run.joints.size(); ++i) {
    const std::size_t column = kBoxColumns + i;
    for (std::size_t row = 0; row < squeezed.table.rows(); ++row) {
      away =
          std::max(away, std::abs(squeezed.table.at(row, column) - twisted.table.at(row, column)));
    }
  }
  // Torques are constant for 1 ms, during which internal forces change by millinewtons.
  EXPECT_LT(away, 1e-5);
}

}  // namespace
