// The tool behaves as if springs and dampers held it, and a hand pushes it, in a loop at 1 kHz.
#include <algorithm>
#include <core/orientation.hpp>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <servo/realtime.hpp>
#include <servo/run_for.hpp>
#include <servo/simulated_robot.hpp>

#include "arm.hpp"
#include "arm_joints.hpp"

using namespace treeline;

struct Arm {  // for the loop, which brakes by inverse dynamics, and for the simulated robot
  static constexpr int kCoordinates = 6, kVelocities = 6;
  static inline double hand[6] = {};  // N, N m
  static void inverse_dynamics(const double (&q)[6], const double (&qd)[6], const double (&qdd)[6],
                               double (&tau)[6]) {
    const double unknown[6] = {};
    arm::inverse_dynamics(q, qd, qdd, unknown, tau);
  }
  static void forward_dynamics(const double (&q)[6], const double (&qd)[6], const double (&tau)[6],
                               double (&qdd)[6]) {
    arm::forward_dynamics(q, qd, tau, hand, qdd);
  }
};
using State = servo::StateOf<Arm>;

struct Impedance {
  static constexpr double kStiffness[6] = {500, 500, 500, 100, 100, 100};  // N/m, N m/rad
  static constexpr double kViscosity[6] = {150, 150, 150, 10, 10, 10};     // N s/m, N m s/rad
  double place[3], turn[9], error[6];

  void start(double, const State& state) { arm::forward_kinematics(state.q, place, turn); }
  void apply(double, const servo::Message&) {}
  void control(double, const State& state, double (&tau)[6]) {
    double position[3], rotation[9], J[36];
    arm::forward_kinematics(state.q, position, rotation);
    arm::jacobian(state.q, J);
    arm::gravity(state.q, tau);
    core::pose_error(position, rotation, place, turn, error);
    for (int row = 0; row < 6; ++row) {
      double velocity = 0;
      for (int i = 0; i < 6; ++i) velocity += J[6 * row + i] * state.qd[i];
      const double force = kStiffness[row] * error[row] - kViscosity[row] * velocity;
      for (int i = 0; i < 6; ++i) tau[i] += J[6 * row + i] * force;
    }
  }
};

template <class Clock>
int run(Clock clock) {
  servo::SimulatedRobot<Arm> robot(State{{0, -0.9, 1.5, -0.6, 1.2, 0}, {}});
  Impedance law;
  servo::Mailbox mailbox;
  const auto limits = servo::limits_of(arm::kLowerLimits, arm::kUpperLimits, arm::kVelocityLimits,
                                       arm::kEffortLimits);
  std::printf("time_s,q0,q1,q2,q3,q4,q5\n");
  double pushed = 0, left = 0;
  const auto end = servo::run_for<Arm>(
      4, {}, limits, robot, law, clock, mailbox, [&](const servo::Report<Arm>& report) {
        Arm::hand[2] = report.time > 0.5 && report.time < 2 ? -50 : 0;
        if (report.time < 2) pushed = 1e3 * law.error[2];
        left = 1e3 * law.error[2];
        if (report.cycle % 50 != 0) return;
        std::printf("%.3f", report.time);
        for (const double coordinate : report.state.q) std::printf(",%.9f", coordinate);
        std::printf("\n");
      });
  std::fprintf(stderr, "50 N push it down by %.1f mm, and it returns to %.1f mm\n", pushed, left);
  std::fprintf(stderr, "a step of control takes %.1f us at the median, %.1f us at most\n",
               1e-3 * end.control.median(), 1e-3 * end.control.maximum());
  if (end.fault) std::fprintf(stderr, "stopped: %s\n", servo::describe(end.fault, "").c_str());
  return end.fault ? 1 : 0;
}

int main(int argc, char** argv) {
  if (argc < 2 || std::strcmp(argv[1], "--realtime") != 0) return run(servo::SimulatedClock{});
  std::fprintf(stderr, "%s\n", servo::request_realtime().c_str());
  return run(servo::SteadyClock{});
}
