// Moves the tool of a simulated UR10e by 30 cm in two seconds, controlled at 1 kHz.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <servo/loop.hpp>
#include <servo/pose_task_controller.hpp>
#include <servo/realtime.hpp>
#include <servo/simulated_robot.hpp>

#include "arm.hpp"

using namespace treeline;

// The generated functions, as the loop and the controller take them.
struct Arm {
  static constexpr int kCoordinates = arm::kCoordinates;
  static constexpr int kVelocities = arm::kVelocities;
  static constexpr int kTaskRows = arm::kTaskRows;
  static constexpr auto& inverse_dynamics = arm::inverse_dynamics;
  static constexpr auto& forward_dynamics = arm::forward_dynamics;
  static constexpr auto& forward_kinematics = arm::forward_kinematics;
  static constexpr auto& jacobian = arm::jacobian;
  static constexpr auto& control_torque = arm::control_torque;
};

using Robot = servo::SimulatedRobot<Arm>;
using Controller = servo::PoseTaskController<Arm>;

// The limits of the URDF, as arm.hpp lists them. The loop brakes the arm when one is exceeded.
servo::SafetyLimits<Arm::kCoordinates, Arm::kVelocities> limits() {
  servo::SafetyLimits<Arm::kCoordinates, Arm::kVelocities> limits;
  limits.lower = {-6.28, -6.28, -3.14, -6.28, -6.28, -6.28};  // rad
  limits.upper = {6.28, 6.28, 3.14, 6.28, 6.28, 6.28};        // rad
  limits.velocity = {2.09, 2.09, 3.14, 3.14, 3.14, 3.14};     // rad/s
  limits.torque = {330, 330, 150, 56, 56, 56};                // N m
  return limits;
}

// Asks the controller to move the tool by (x, y, z) metres in two seconds; the tool does not turn.
servo::Message move_tool(const Controller& controller, double x, double y, double z) {
  const auto& now = controller.tracking(0);  // operational point 0
  servo::Message message;
  message.kind = servo::MessageKind::move_point;
  message.index = 0;
  message.duration = 2.0;
  message.values[0] = now.position[0] + x;
  message.values[1] = now.position[1] + y;
  message.values[2] = now.position[2] + z;
  std::copy(std::begin(now.rotation), std::end(now.rotation), message.values.begin() + 3);
  return message;
}

template <class Clock>
int reach(Clock& clock) {
  const servo::StateOf<Arm> at_rest{{0, -1.6, 1.6, -1.6, -1.6, 0}, {}};  // q and qd
  Robot robot(at_rest);
  const core::Gains<double> task{400, 40};  // 1/s^2 and 1/s: critically damped
  std::array<core::Gains<double>, Arm::kVelocities> posture;
  posture.fill({25, 10});
  Controller controller(task, posture);
  servo::Mailbox mailbox;
  auto loop = std::make_unique<servo::ServoLoop<Arm, Robot, Controller, Clock>>(
      servo::LoopSettings{}, limits(), robot, controller, clock, mailbox);

  servo::Message start;
  start.kind = servo::MessageKind::start;
  mailbox.push(start);
  bool moving = false;
  bool leaving = false;
  double worst = 0.0;
  loop->run([&](const servo::Report<Arm>& report) {  // called in every cycle
    if (!moving && report.time > 0.5) moving = mailbox.push(move_tool(controller, 0, 0.2, -0.22));
    if (!leaving && report.time > 3.0) {
      servo::Message leave;
      leave.kind = servo::MessageKind::disconnect;
      leaving = mailbox.push(leave);
    }
    const double* error = controller.tracking(0).error;
    worst = std::max(worst, std::hypot(error[0], error[1], error[2]));
  });

  const double* tool = controller.tracking(0).position;
  std::printf("tool at (%.4f, %.4f, %.4f) m, largest position error %.1e m\n", tool[0], tool[1],
              tool[2], worst);
  std::printf("control %.1f us at the median, %.1f us at most; lateness %.1f us at the median\n",
              1e-3 * loop->control_times().median(), 1e-3 * loop->control_times().maximum(),
              1e-3 * loop->cycle().jitters().median());
  if (loop->fault()) std::printf("stopped: %s\n", servo::describe(loop->fault(), "").c_str());
  return loop->fault() ? 1 : 0;
}

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--realtime") == 0) {
    const std::string refused = servo::request_realtime();
    if (!refused.empty()) std::printf("%s\n", refused.c_str());
    servo::SteadyClock clock;  // waits for every millisecond
    return reach(clock);
  }
  servo::SimulatedClock clock;  // the same cycles, as fast as possible
  return reach(clock);
}
