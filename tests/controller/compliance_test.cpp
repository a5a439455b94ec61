// Would catch: compliance that gives back more energy than it was given, whose stiffness is not
// that of the configuration, or that moves an arm which nobody pushes; a torque that steps where it
// begins.
#include <algorithm>
#include <cmath>
#include <random>

#include "controller/simulated_arm.hpp"

namespace treeline::tests {
namespace {

constexpr int n = SimulatedArm::n;

double largest_error(const SimulatedArm& arm) {
  double most = 0;
  for (int i = 0; i < n; ++i) {
    most = std::max(most, std::fabs(arm.input.q[i] - arm.state.joint_motion[i]));
  }
  return most;
}

/// Complies where nothing is a fault that a push brings about, and torques change as fast as asked.
SimulatedArm complying(double joint, double point, double turn) {
  SimulatedArm arm = running();
  arm.config.period = 1e-4;  // so that it is the law that is judged, and not its sampling
  arm.config.jump = 1e9;
  arm.config.speed_margin = 10;  // light wrists are quick
  for (double& limit : arm.config.torque) limit = 1e4;
  for (int i = 0; i < n; ++i) {  // whose springs at the ends are none of the energy below
    arm.config.lower[i] = -1e3;
    arm.config.upper[i] = 1e3;
  }
  for (double& rate : arm.config.torque_rate) rate = 1e9;
  // The wrist of this model has 4e-5 kg m^2 about its last axis: no motor, no gear.
  const double light[n] = {1, 1, 1, 2e-2, 2e-2, 1e-3};
  for (int i = 0; i < n; ++i) arm.config.joint_stiffness[i] = joint * light[i];
  for (int i = 0; i < 6; ++i) {
    arm.config.point_stiffness[i] = i < 3 ? point : turn;
    arm.config.point_viscosity[i] = i < 3 ? 0.02 * point : 0.02 * turn;
  }
  arm.send(PUMA_ARM_COMPLY);
  arm.run(0.15);
  EXPECT_EQ(arm.output.refused, 0);
  EXPECT_LT(largest_error(arm), 1e-9) << "nobody pushes";
  return arm;
}

/// Energy of motion and of the springs, J.
double energy(const SimulatedArm& arm) {
  double E[1];
  puma_arm::kinetic_energy(arm.input.q, arm.input.qd, E);
  double sum = E[0];
  for (int i = 0; i < n; ++i) {
    const double away = arm.input.q[i] - arm.state.joint_motion[i];
    sum += 0.5 * arm.config.joint_stiffness[i] * away * away;
  }
  double p[3], R[9];
  arm.pose(p, R);
  double trace = 0, square = 0;
  for (int i = 0; i < 3; ++i) {
    const double away = p[i] - arm.state.point_motion[i];
    sum += 0.5 * arm.config.point_stiffness[i] * away * away;
    for (int k = 0; k < 3; ++k) trace += R[3 * i + k] * arm.state.point_from[3 * i + k];
  }
  square = std::acos(std::min(1.0, 0.5 * (trace - 1)));
  return sum + 0.5 * arm.config.point_stiffness[3] * square * square;
}

/// Kicks the arm and follows its energy. Symplectic Euler of a period h keeps it to a share of
/// about w h, where w is what moves fastest, at most some 60 rad/s here.
void expect_passive(SimulatedArm arm, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (double& qd : arm.input.qd) qd = 0.8 * unit(rng);
  const double given = energy(arm);
  double most = given;
  for (int k = 0; k < 30000; ++k) {
    arm.step();
    ASSERT_EQ(arm.output.mode, PUMA_ARM_RUNNING) << "seed " << seed << " step " << k;
    arm.move();
    const double now = energy(arm);
    ASSERT_LT(now, most + 0.01 * given) << "seed " << seed << " step " << k;
    most = std::min(most, now);
  }
  EXPECT_LT(energy(arm), 0.1 * given) << "seed " << seed;
}

TEST(Compliance, OfJointsIsPassive) {
  for (unsigned seed = 1; seed <= 3; ++seed) expect_passive(complying(40, 0, 0), seed);
}

TEST(Compliance, OfPointsIsPassive) {
  for (unsigned seed = 1; seed <= 3; ++seed) expect_passive(complying(0, 400, 0.05), seed);
}

TEST(Compliance, LetsTheArmBeLedByHand) {
  SimulatedArm arm = complying(0, 0, 0);
  const double from = arm.input.q[1];
  for (int k = 0; k < 10000; ++k) {
    arm.step();
    arm.move({0, 8, 0, 0, 0, 0});
  }
  EXPECT_GT(arm.input.q[1] - from, 0.2) << "8 N m lead the shoulder";
  arm.run(2);
  EXPECT_EQ(arm.output.faults, 0U);
  for (const double qd : arm.input.qd)
    EXPECT_LT(std::fabs(qd), 0.02) << "it stays where it was led";
  EXPECT_GT(arm.input.q[1] - from, 0.2);
}

TEST(Compliance, HasTheStiffnessOfTheConfiguration) {
  SimulatedArm arm = complying(50, 0, 0);
  for (int k = 0; k < 60000; ++k) {
    arm.step();
    arm.move({5, 0, 0, 0, 0, 0});
  }
  EXPECT_NEAR(arm.input.q[0] - arm.state.joint_motion[0], 5.0 / 50, 1e-3);
  SimulatedArm point = complying(0, 300, 0.05);
  double p[3], R[9], J[6 * n];
  for (int k = 0; k < 80000; ++k) {
    puma_arm::jacobian(point.input.q, J);
    std::array<double, 6> outside{};
    for (int i = 0; i < n; ++i) outside[static_cast<std::size_t>(i)] = 6 * J[2 * n + i];
    point.step();
    point.move(outside);
  }
  point.pose(p, R);
  EXPECT_NEAR(p[2] - point.state.point_motion[2], 6.0 / 300, 1e-3);
}

/// Lets one joint move for a period, while the others are held.
void move_alone(SimulatedArm& arm, int joint) {
  double still[n] = {}, unit[n] = {}, without[n], with[n];
  unit[joint] = 1;
  puma_arm::inverse_dynamics(arm.input.q, arm.input.qd, still, without);
  puma_arm::inverse_dynamics(arm.input.q, arm.input.qd, unit, with);
  const double inertia = with[joint] - without[joint];
  arm.input.qd[joint] += arm.config.period * (arm.output.tau[joint] - without[joint]) / inertia;
  arm.input.q[joint] += arm.config.period * arm.input.qd[joint];
}

// Would catch: a ratio that damps by another inertia. One joint swings about its spring, the others
// are held; the overshoot of a ratio z is exp(-pi z / sqrt(1 - z^2)).
TEST(Compliance, DampsByARatio) {
  for (const int joint : {0, 1, 2}) {
    for (const double ratio : {0.2, 0.5, 1.0}) {
      SimulatedArm arm = complying(0, 0, 0);
      arm.config.comply_damping = 0;
      for (int i = 0; i < n; ++i) arm.config.joint_stiffness[i] = i == joint ? 60 : 0;
      arm.config.joint_damping_ratio[joint] = ratio;
      arm.input.q[joint] += 0.05;
      const double start = arm.input.q[joint];
      double beyond = 0;
      for (int k = 0; k < 30000; ++k) {
        arm.step();
        move_alone(arm, joint);
        beyond = std::max(beyond, arm.state.joint_motion[joint] - arm.input.q[joint]);
      }
      const double root = std::sqrt(1 - ratio * ratio);
      const double expected = ratio < 1 ? std::exp(-M_PI * ratio / root) : 0;
      EXPECT_NEAR(beyond / (start - arm.state.joint_motion[joint]), expected, 0.01)
          << "joint " << joint << " ratio " << ratio;
    }
  }
}

// Would catch: springs that stay where they were, a step in torque where they set out, and a goal
// beyond a joint's limits that is accepted.
TEST(Compliance, IsLedAlong) {
  SimulatedArm arm = complying(200, 0, 0);
  std::array<double, 6> goal{};
  for (int i = 0; i < n; ++i) goal[static_cast<std::size_t>(i)] = arm.input.q[i] + 0.1;
  for (int i = 0; i < n; ++i) {
    arm.config.joint_damping_ratio[i] = 1;
    arm.input.command.goal[i] = goal[static_cast<std::size_t>(i)];
  }
  arm.run(0.01);
  double before[n];
  for (int i = 0; i < n; ++i) before[i] = arm.output.tau[i];
  arm.input.command.duration = 1;
  arm.send(PUMA_ARM_LEAD_JOINTS);
  arm.step();
  EXPECT_EQ(arm.output.refused, 0);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(arm.output.tau[i], before[i], 1e-6) << i;
  arm.run(6);
  EXPECT_EQ(arm.state.law, 2);
  for (int i = 0; i < n; ++i) {
    EXPECT_NEAR(arm.input.q[i], goal[static_cast<std::size_t>(i)], 2e-3) << i;
  }
  arm.input.command.goal[0] = 2e3;
  arm.send(PUMA_ARM_LEAD_JOINTS);
  arm.step();
  EXPECT_EQ(arm.output.refused, PUMA_ARM_REFUSED_LIMITS);
  SimulatedArm stiff = running();
  stiff.send(PUMA_ARM_LEAD_JOINTS);
  stiff.step();
  EXPECT_EQ(stiff.output.refused, PUMA_ARM_REFUSED_MODE);
}

TEST(Compliance, LeadsAPoint) {
  SimulatedArm arm = complying(0, 400, 0.05);
  double p[3], R[9];
  arm.pose(p, R);
  for (int i = 0; i < 3; ++i) arm.input.command.position[i] = p[i] + (i == 2 ? 0.05 : 0);
  for (int i = 0; i < 9; ++i) arm.input.command.rotation[i] = R[i];
  arm.input.command.duration = 1;
  arm.send(PUMA_ARM_LEAD_POINT);
  arm.step();
  EXPECT_EQ(arm.output.refused, 0);
  arm.run(6);
  double there[3];
  arm.pose(there, R);
  EXPECT_NEAR(there[2], p[2] + 0.05, 2e-3);
  EXPECT_EQ(arm.state.law, 2);
}

TEST(Compliance, BeginsAndEndsWithoutAStepInTorque) {
  SimulatedArm arm = running();
  arm.input.qd[1] = 0.3;
  arm.config.jump = 1e9;
  for (double& rate : arm.config.torque_rate) rate = 1e9;
  arm.step();
  const double before = arm.output.tau[1];
  arm.send(PUMA_ARM_COMPLY);
  arm.step();
  EXPECT_NEAR(arm.output.tau[1], before, 1e-9);
  arm.move_joints({0.3, -0.9, 0.6, 0.2, 0.8, -0.4}, 1);
  arm.step();
  EXPECT_EQ(arm.output.refused, 0);
  EXPECT_NEAR(arm.output.tau[1], before, 0.1);
}

}  // namespace
}  // namespace treeline::tests
