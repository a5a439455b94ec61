// Chang fig. 6.6 to 6.11 on generated code: the physical claims. Would catch: a motion of the base
// that affects the tool, a base that does not follow, friction or backlash with no effect or too
// much, and limits that are not the robot's.
#include "circles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "description/read_urdf.hpp"

namespace treeline::experiments {
namespace {

TEST(Circles, BaseMovesWithoutTheToolsNoticing) {
  const std::vector<CircleRun> runs = run_all_circles();
  ASSERT_EQ(runs.size(), 8U);
  EXPECT_EQ(broken_circle_claims(runs), "") << circles_summary(runs);
  // Backlash alone is invisible to the motors' encoders: the tool's error is larger than they show.
  const CircleErrors& backlash = runs[4].errors;
  EXPECT_EQ(runs[4].model, DriveModel::backlash);
  EXPECT_GT(backlash.tool, 10 * backlash.tool_seen);
  EXPECT_GT(runs[6].errors.tool, runs[2].errors.tool);  // both are worse than friction alone
}

/// Acceleration of the generated robot under the generated torque.
void accelerate(const double (&q)[9], const double (&qd)[9], const double (&qdd_0)[9],
                const double (&xdd_cmd)[6], double (&xdd)[6], double (&qdd)[9]) {
  double tau[9];
  double J[54];
  samm::control_torque(q, qd, qdd_0, xdd_cmd, tau);
  samm::forward_dynamics(q, qd, tau, qdd);
  samm::jacobian(q, J);
  samm::bias_acceleration(q, qd, xdd);
  for (int i = 0; i < 54; ++i) {
    xdd[i / 9] += J[i] * qdd[i % 9];
  }
}

// The claim without integration: the base follows any command, and the tool's motion is not
// affected. Rounding: 16 digits divided by the condition number of Lambda, 5e5, and accelerations
// of 10.
TEST(Circles, BaseAndToolAccelerateAsCommanded) {
  std::mt19937_64 random(66);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const CirclePlan plan;
  for (int round = 0; round < 200; ++round) {
    double q[9];
    double qd[9];
    double xdd_cmd[6];
    double b[3];
    for (int i = 0; i < 9; ++i) {
      q[i] = plan.start[i] + 0.2 * number(random);
      qd[i] = number(random);
    }
    for (double& component : xdd_cmd) component = 5 * number(random);
    for (double& component : b) component = 5 * number(random);
    double qdd_0[9];
    double xdd[6];
    double qdd[9];
    base_posture(q, qd, xdd_cmd, b, qdd_0);
    accelerate(q, qd, qdd_0, xdd_cmd, xdd, qdd);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(xdd[i], xdd_cmd[i], 1e-8) << "round " << round;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(qdd[i], b[i], 1e-8) << "round " << round;
  }
}

TEST(Circles, LimitsAreTheRobotsOwn) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(TREELINE_ROBOTS_DIR "/samm/samm.urdf", diagnostics);
  ASSERT_TRUE(robot);
  const auto limits = samm_limits();
  std::size_t at = 0;
  for (const Joint& joint : robot->joints) {
    if (joint.type == JointType::fixed) continue;
    ASSERT_LT(at, 9U);
    ASSERT_TRUE(joint.limits) << joint.name;
    if (joint.type != JointType::continuous) {
      EXPECT_EQ(limits.lower[at], joint.limits->lower) << joint.name;
      EXPECT_EQ(limits.upper[at], joint.limits->upper) << joint.name;
    }
    EXPECT_EQ(limits.velocity[at], joint.limits->velocity) << joint.name;
    EXPECT_EQ(limits.torque[at], joint.limits->effort) << joint.name;
    ++at;
  }
  EXPECT_EQ(at, 9U);
}

}  // namespace
}  // namespace treeline::experiments
