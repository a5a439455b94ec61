// The integrator compared with conservation laws and closed-form motions; its order by halving
// steps. Would catch: a wrong stage weight, a quaternion rotated in the wrong axes, a twist that is
// taken for a world velocity, and torque that is not held.
#include <gtest/gtest.h>

#include <cmath>

#include "servo/integrate.hpp"
#include "servo/simulated_robot.hpp"
#include "test_robots.hpp"

namespace {

using namespace treeline::servo;  // NOLINT: all of it is under test
using treeline::test::FreeBody;
using treeline::test::TwoLink;

RobotState<2, 2> swing(int steps) {
  RobotState<2, 2> state;
  state.q[0] = 0.3;
  state.q[1] = 0.9;
  state.qd[0] = 1.0;
  const double no_torque[2] = {};
  for (int i = 0; i < steps; ++i) {
    integrate_runge_kutta<TwoLink>({}, no_torque, 1.0 / steps, state);
  }
  return state;
}

TEST(RungeKutta, IsOfFourthOrderAndKeepsEnergy) {
  const RobotState<2, 2> exact = swing(6400);
  const double coarse = std::fabs(swing(100).q[0] - exact.q[0]);
  const double fine = std::fabs(swing(200).q[0] - exact.q[0]);
  EXPECT_NEAR(coarse / fine, 16.0, 3.0);
  const RobotState<2, 2> begin = swing(0);
  EXPECT_NEAR(TwoLink::energy(exact.q, exact.qd), TwoLink::energy(begin.q, begin.qd), 1e-11);
}

RobotState<7, 6> thrown_body() {
  RobotState<7, 6> state;
  state.q[6] = 1.0;  // axes parallel to the world's
  state.qd[0] = 3.0;
  state.qd[2] = 4.0;
  state.qd[3] = 2.0;
  state.qd[5] = 5.0;
  return state;
}

// A free top spins about its moving axis of symmetry and falls along a parabola, whatever its spin.
TEST(RungeKutta, FreeBodyFallsAndPrecesses) {
  const FloatingJoints<7, 6> floating{0};
  RobotState<7, 6> state = thrown_body();
  const double no_force[6] = {};
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    integrate_runge_kutta<FreeBody>(floating, no_force, 1.0 / kSteps, state);
  }
  EXPECT_NEAR(state.q[0], 3.0, 1e-9);
  EXPECT_NEAR(state.q[1], 0.0, 1e-9);
  EXPECT_NEAR(state.q[2], 4.0 - 9.81 / 2.0, 1e-9);
  // Euler: the transverse angular velocity rotates with (I3 - I1) / I1 w3.
  const double rate = (0.5 - 0.3) / 0.3 * 5.0;
  EXPECT_NEAR(state.qd[3], 2.0 * std::cos(rate), 1e-9);
  EXPECT_NEAR(state.qd[4], 2.0 * std::sin(rate), 1e-9);
  EXPECT_NEAR(state.qd[5], 5.0, 1e-12);
  // Angular momentum in the world is constant (0.6, 0, 2.5): R (I w).
  const double* u = state.q + 3;
  const double L[3] = {0.3 * state.qd[3], 0.3 * state.qd[4], 0.5 * state.qd[5]};
  const double Lx =
      L[0] + 2.0 * (u[3] * (u[1] * L[2] - u[2] * L[1]) + u[1] * (u[0] * L[1] - u[1] * L[0]) -
                    u[2] * (u[2] * L[0] - u[0] * L[2]));
  EXPECT_NEAR(Lx, 0.6, 1e-9);
  EXPECT_NEAR(u[0] * u[0] + u[1] * u[1] + u[2] * u[2] + u[3] * u[3], 1.0, 1e-15);
}

TEST(SimulatedRobot, HoldsItsTorqueBetweenWrites) {
  RobotState<2, 2> state;
  SimulatedRobot<TwoLink> robot(state, 4);
  // Gravity is held exactly, so the robot must not move, however long.
  double tau[2];
  const double nothing[2] = {};
  TwoLink::inverse_dynamics(state.q, state.qd, nothing, tau);
  robot.write(tau);
  for (int i = 0; i < 100; ++i) {
    robot.pass_time(0.001);
  }
  robot.read(state);
  EXPECT_NEAR(state.q[0], 0.0, 1e-12);
  EXPECT_NEAR(state.qd[1], 0.0, 1e-12);
}

}  // namespace
