// What the tutorial asks of any arm: rows of a task by name, a pose to begin from, gains of its
// posture. Would catch: rows that go to another axis or point, a start that is stretched, beyond
// limits, at one of them, or too heavy for the motors, and fingers that the task shakes off.
#include <gtest/gtest.h>

#include <cmath>

#include "servo/bent_pose.hpp"
#include "servo/pose_task_controller.hpp"
#include "servo/task_rows.hpp"

namespace {

using namespace treeline::servo;  // NOLINT: all of it is under test

/// Two links of a metre in the plane x y, and a finger that does not move their end. The first
/// motor carries a weight that grows as the arm reaches out, of `kWeight` N m when it is stretched.
struct PlanarArm {
  static constexpr int kCoordinates = 3, kVelocities = 3, kTaskRows = 2;
  static constexpr const char* kTaskRowNames[2] = {"end of arm y", "end of arm rz"};
  static constexpr double kWeight = 100;

  static void forward_kinematics(const double (&q)[3], double (&position)[3],
                                 double (&rotation)[9]) {
    const double turn = q[0] + q[1];
    const double at[3] = {std::cos(q[0]) + std::cos(turn), std::sin(q[0]) + std::sin(turn), 0};
    const double axes[9] = {
        std::cos(turn), -std::sin(turn), 0, std::sin(turn), std::cos(turn), 0, 0, 0, 1};
    for (int i = 0; i < 3; ++i) position[i] = at[i];
    for (int i = 0; i < 9; ++i) rotation[i] = axes[i];
  }
  static void jacobian(const double (&q)[3], double (&J)[6]) {
    const double outer = std::cos(q[0] + q[1]);
    const double rows[6] = {std::cos(q[0]) + outer, outer, 0, 1, 1, 0};
    for (int i = 0; i < 6; ++i) J[i] = rows[i];
  }
  static void inverse_dynamics(const double (&q)[3], const double (&)[3], const double (&)[3],
                               double (&tau)[3]) {
    tau[0] = kWeight / 2 * (std::cos(q[0]) + std::cos(q[0] + q[1]));
    tau[1] = tau[2] = 0;
  }
  /// Hands back what was commanded.
  static void control_torque(const double (&)[3], const double (&)[3], const double (&)[3],
                             const double (&xdd)[2], double (&tau)[3]) {
    tau[0] = xdd[0];
    tau[1] = xdd[1];
    tau[2] = 0;
  }
};

TEST(TaskRows, AreReadFromNames) {
  constexpr const char* kNames[] = {"left hand x", "left hand rz", "right z", "right rx"};
  constexpr auto rows = task_rows(kNames);
  const int expected[4][2] = {{0, 0}, {0, 5}, {1, 2}, {1, 3}};
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_EQ(rows[row].point, expected[row][0]) << row;
    EXPECT_EQ(rows[row].axis, expected[row][1]) << row;
  }
  EXPECT_EQ(kTaskPoints<PlanarArm>, 1);
}

TEST(PoseTaskController, CommandsTheRowsThatTheTaskHas) {
  const StateOf<PlanarArm> state{{0.3, 0.9, 0}, {}};
  PoseTaskController<PlanarArm> controller({100, 0}, posture_gains<PlanarArm>(state.q, {25, 10}));
  controller.start(0, state);
  const StateOf<PlanarArm> other{{0.35, 0.88, 0}, {}};
  double tau[3];
  controller.control(0, other, tau);
  const auto end = [](const StateOf<PlanarArm>& at) {
    return std::sin(at.q[0]) + std::sin(at.q[0] + at.q[1]);
  };
  EXPECT_NEAR(tau[0], 100 * (end(state) - end(other)), 1e-12);
  EXPECT_NEAR(tau[1], -100 * 0.03, 1e-12);
}

TEST(PostureGains, HoldWhatDoesNotMoveTheTaskMoreFirmly) {
  const auto gains = posture_gains<PlanarArm>({0.3, 0.9, 0}, {25, 10});
  EXPECT_EQ(gains[0].kp, 25);
  EXPECT_EQ(gains[1].kv, 10);
  EXPECT_EQ(gains[2].kp, 2500);
  EXPECT_EQ(gains[2].kv, 100);
}

TEST(BentPose, IsBentWithinLimitsAndLightEnough) {
  SafetyLimits<3, 3> limits;
  limits.lower = {-3, -2.5, 0};
  limits.upper = {3, 2.5, 0.04};
  limits.torque = {120, 50, 1};
  const auto start = bent_pose<PlanarArm>({0, 0, 0}, limits);
  for (std::size_t i = 0; i < 3; ++i) {
    const double margin = 0.1 * (limits.upper[i] - limits.lower[i]);
    EXPECT_GE(start.q[i], limits.lower[i] + margin - 1e-12) << i;
    EXPECT_LE(start.q[i], limits.upper[i] - margin + 1e-12) << i;
    EXPECT_EQ(start.qd[i], 0);
  }
  // Rows y and rz of this arm depend on each other where cos(q0) is 0: it stays away from there.
  EXPECT_GT(std::fabs(std::cos(start.q[0])), 0.5);
  double weight[3];
  PlanarArm::inverse_dynamics(start.q, start.qd, start.qd, weight);
  EXPECT_LE(std::fabs(weight[0]), 0.55 * limits.torque[0]);
  EXPECT_GT(dexterity<PlanarArm>(limits, start.q), dexterity<PlanarArm>(limits, {0, 0, 0.02}));
}

TEST(BentPose, BeginsAtHomeWhereNothingLimitsIt) {
  const SafetyLimits<3, 3> none;
  const auto start = bent_pose<PlanarArm>({0, 0, 0.5}, none);
  EXPECT_EQ(start.q[2], 0.5);  // the finger changes nothing
}

}  // namespace
