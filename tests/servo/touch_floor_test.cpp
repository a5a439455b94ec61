// The touch-floor experiment with two free hands that need no generated code, and the reading of
// its files. Would catch: swapped hands, errors measured relative to the wrong reference, a fault
// that looks like success, and a plan or limits read in the wrong order.
#include "touch_floor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "outcome.hpp"
#include "plan.hpp"
#include "report/table.hpp"
#include "servo/clock.hpp"
#include "test_robots.hpp"

namespace {

using namespace treeline::experiments;  // NOLINT: all of it is under test
using treeline::servo::FaultKind;
using treeline::servo::SimulatedClock;
using treeline::test::TwoHands;

Plan small_plan() {
  Plan plan;
  for (int i = 0; i < 12; ++i) {
    plan.joints.push_back("joint" + std::to_string(i));
  }
  plan.start.assign(12, 0.1);
  plan.spring = 10.0;
  plan.limit_margin = 0.2;
  plan.limit_strength = 100.0;
  plan.target = {0.3, 0.4, 0.0};
  plan.duration = 1.0;
  plan.settle = 0.5;
  plan.rate = 1000.0;
  plan.stiffness = 6400.0;
  plan.damping = 160.0;
  return plan;
}

JointLimits wide_limits() {
  return {std::vector<double>(12, -2.0), std::vector<double>(12, 2.0),
          std::vector<double>(12, 10.0), std::vector<double>(12, 100.0)};
}

TEST(TouchFloor, LeftHandArrivesAlongTheSplineRightHandStays) {
  const Plan plan = small_plan();
  SimulatedClock clock;
  const Outcome outcome = touch_floor<TwoHands>(plan, {}, wide_limits(), clock);
  EXPECT_FALSE(outcome.fault);
  EXPECT_TRUE(within_bounds(outcome));
  const auto& table = outcome.table;
  ASSERT_EQ(table.columns(), table_names(plan.joints).size());
  ASSERT_EQ(table.rows(), 1751U);
  const std::size_t last = table.rows() - 1;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(table.at(last, 4 + i), plan.target[i], 1e-7);
  }
  // Right hand of TwoHands at q = 0.1: (0.1, 0.1 - 0.5, 1.1).
  EXPECT_NEAR(table.at(last, 12), 0.1, 1e-9);
  EXPECT_NEAR(table.at(last, 13), -0.4, 1e-9);
  EXPECT_NEAR(table.at(last, 14), 1.1, 1e-9);
  // The message is sent after the lead of 0.25 s and applied one cycle later: halfway at 0.751 s.
  EXPECT_NEAR(table.at(751, 3), 0.5 * (1.1 + 0.0), 1e-9);
  EXPECT_EQ(outcome.skips, 0U);
  EXPECT_EQ(outcome.periods.maximum(), 1e6);
}

TEST(TouchFloor, AFaultEndsTheRunAndIsReported) {
  const Plan plan = small_plan();
  JointLimits limits = wide_limits();
  limits.lower[2] = -0.5;  // the left hand would have to go to -1
  SimulatedClock clock;
  const Outcome outcome = touch_floor<TwoHands>(plan, {}, limits, clock);
  EXPECT_EQ(outcome.fault.kind, FaultKind::position_limit);
  EXPECT_EQ(outcome.fault.index, 2);
  EXPECT_LT(outcome.table.rows(), 1000U);
}

TEST(TouchFloor, SaysSoWhenABoundIsBroken) {
  Plan plan = small_plan();
  plan.stiffness = 1.0;
  plan.damping = 0.5;
  plan.rate = 20.0;
  SimulatedClock clock;
  const Outcome outcome = touch_floor<TwoHands>(plan, {}, wide_limits(), clock);
  EXPECT_FALSE(within_bounds(outcome));
  EXPECT_NE(summary(outcome, plan, false).find("BROKEN"), std::string::npos);
  EXPECT_GT(largest_errors(outcome.table).left_position, 1e-4);
}

TEST(TouchFloor, FigureHasTheThesisPanels) {
  const Plan plan = small_plan();
  SimulatedClock clock;
  const Outcome outcome = touch_floor<TwoHands>(plan, {}, wide_limits(), clock);
  const auto plot = figure(outcome, plan);
  ASSERT_EQ(plot.panels.size(), 5U);
  EXPECT_EQ(plot.panels[0].lines.size(), 6U);
  EXPECT_EQ(plot.x.size(), outcome.table.rows());
  // Posture: the axis with the largest travel comes first, relative to the start.
  EXPECT_EQ(plot.panels[3].lines[0].name, "joint2");
  EXPECT_NEAR(plot.panels[3].lines[0].values.back(), -1.1, 1e-6);
}

TEST(TouchFloor, ReadsTheHumanoidsPlanAndLimits) {
  const std::string folder = TREELINE_ROBOTS_DIR "/humanoid24";
  Plan plan;
  JointLimits limits;
  std::string error;
  ASSERT_TRUE(read_plan(folder + "/touch_floor.yaml", plan, error)) << error;
  ASSERT_EQ(plan.joints.size(), 24U);
  EXPECT_EQ(plan.joints.front(), "ankle");
  EXPECT_EQ(plan.target[2], 0.0016);
  EXPECT_EQ(plan.spring, 60.0);
  EXPECT_EQ(plan.limit_margin, 0.2);
  EXPECT_EQ(plan.limit_strength, 200.0);
  ASSERT_TRUE(read_limits(folder + "/humanoid24.urdf", plan.joints, limits, error)) << error;
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_LT(limits.lower[i], plan.start[i]) << plan.joints[i];
    EXPECT_GT(limits.upper[i], plan.start[i]) << plan.joints[i];
    EXPECT_GT(limits.effort[i], 0.0) << plan.joints[i];
  }
  plan.joints.emplace_back("tail");
  EXPECT_FALSE(read_limits(folder + "/humanoid24.urdf", plan.joints, limits, error));
  EXPECT_NE(error.find("'tail'"), std::string::npos);
}

TEST(TouchFloor, RefusesBrokenPlans) {
  const char* const kBroken[] = {
      "",
      "start: [1, 2]",
      "start: {a: x}",
      "{start: {a: 0}, posture_stiffness: {b: 1}}",
      "{start: {a: 0}, posture_stiffness: {a: 1}, springs: {stiffness: 0, margin: 1, strength: 1}}",
      "{start: {a: 0}, posture_stiffness: {a: 1}, left_hand: {target: [0, 0], duration: 1}}",
      "{start: {a: 0}, posture_stiffness: {a: 1}, left_hand: {target: [0, 0, 0], duration: -1}}"};
  for (const char* text : kBroken) {
    const std::string path = testing::TempDir() + "broken_plan.yaml";
    ASSERT_EQ(treeline::report::write_text(path, text), "");
    Plan plan;
    std::string error;
    EXPECT_FALSE(read_plan(path, plan, error)) << text;
    EXPECT_NE(error.find(path), std::string::npos) << error;
  }
}

}  // namespace
