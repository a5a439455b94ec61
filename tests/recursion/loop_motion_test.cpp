#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "looped_robot.hpp"

// Robots with loops move by the emitted recursion, in double. Would catch: loops that open or
// energy that appears, rows that prevent each other, and a robot file's loops that are not kept.

namespace treeline::tests {
namespace {

using interpreter::Vector;

const std::vector<double> kGains{40, 400};

// Where rocker and coupler meet follows from the three sides of a triangle.
TEST(FourBar, ClosesWhereTheSidesMeet) {
  const LoopedRobot robot = four_bar();
  for (const double crank : {-2.0, 0.4, 1.3}) {
    Vector<double> q = robot.closed((Vector<double>(3) << crank, -crank, 0).finished());
    const Eigen::Vector2d pin(0.12 * std::sin(q(0)), 0.12 * std::cos(q(0)));
    const Eigen::Vector2d end(0.3 + 0.25 * std::sin(q(2)), 0.25 * std::cos(q(2)));
    EXPECT_NEAR((end - pin).norm(), 0.3, 1e-12);
    EXPECT_LE(robot.errors(q).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(FourBar, KeepsItsEnergyAndStaysClosed) {
  const LoopedRobot robot = four_bar();
  Vector<double> q = robot.closed(kAssembled);
  Vector<double> qd = robot.permitted(q, (Vector<double>(3) << 25, 0, 0).finished());
  const double before = robot.energy(q, qd);
  double open = 0, change = 0;
  for (int i = 0; i < 20000; ++i) {
    robot.step(0.001, kGains, q, qd);
    open = std::max(open, robot.errors(q).cwiseAbs().maxCoeff());
    change = std::max(change, std::abs(robot.energy(q, qd) - before));
  }
  std::cout << "20 s: the loop opens by " << open << " m, the energy of " << before
            << " J changes by " << change << " J\n";
  // What is left is the integrator's: fourth order, at 1 ms and about four turns a second.
  EXPECT_LE(open, 1e-8);
  EXPECT_LE(change, 1e-5 * std::abs(before));
}

// All five rows of the hinge: three depend on the other two in every state.
TEST(FourBar, MovesTheSameWithRowsThatTheRestPreventsAlready) {
  const LoopedRobot two = four_bar(), five = four_bar("[x, y, z, rx, rz]");
  const Vector<double> q = two.closed(kAssembled);
  const Vector<double> qd = two.permitted(q, (Vector<double>(3) << 3, 1, -2).finished());
  const auto expected = two.motion(q, qd, {0, 0});
  const auto moving = five.motion(q, qd, {0, 0});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(moving.qdd[i], expected.qdd[i], 1e-9);
  EXPECT_NEAR(moving.f[0], expected.f[0], 1e-9);
  EXPECT_NEAR(moving.f[2], expected.f[1], 1e-9);
  EXPECT_EQ(moving.f[1], 0);
}

// Five loops of ball joints, from the robot's file.
TEST(Stewart, FallsWithAllLegsAttached) {
  const LoopedRobot robot("stewart.urdf", "");
  Vector<double> q = Vector<double>::Zero(robot.model().nq);
  for (const auto& body : robot.model().bodies) {
    const int quaternion = interpreter::quaternion_of(body);
    if (quaternion >= 0) q(quaternion + 3) = 1;
  }
  q = robot.closed(q);
  ASSERT_LE(robot.errors(q).cwiseAbs().maxCoeff(), 1e-12);
  Vector<double> qd = robot.permitted(q, Vector<double>::Constant(robot.model().nv, 0.3));
  const double before = robot.energy(q, qd);
  for (int i = 0; i < 150; ++i) robot.step(0.001, kGains, q, qd);
  // Steps of the ball joint's quaternion are of second order.
  EXPECT_LE(robot.errors(q).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_NEAR(robot.energy(q, qd), before, 1e-7 * std::abs(before));
  EXPECT_GT(qd.norm(), 1);
}

}  // namespace
}  // namespace treeline::tests
