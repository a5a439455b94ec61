// Moves the tool of a simulated arm in two seconds, controlled at 1 kHz. Nothing here is typed in
// for one robot: sizes, names and limits are those of arm.hpp and arm_joints.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <servo/bent_pose.hpp>
#include <servo/loop.hpp>
#include <servo/pose_task_controller.hpp>
#include <servo/realtime.hpp>
#include <servo/simulated_robot.hpp>

#include "arm.hpp"
#include "arm_joints.hpp"

using namespace treeline;

// The generated functions, as the loop and the controller take them.
struct Arm {
  static constexpr int kCoordinates = arm::kCoordinates;
  static constexpr int kVelocities = arm::kVelocities;
  static constexpr int kTaskRows = arm::kTaskRows;
  static constexpr auto& kTaskRowNames = arm::kTaskRowNames;
  static constexpr auto& inverse_dynamics = arm::inverse_dynamics;
  static constexpr auto& forward_dynamics = arm::forward_dynamics;
  static constexpr auto& forward_kinematics = arm::forward_kinematics;
  static constexpr auto& jacobian = arm::jacobian;
  static constexpr auto& control_torque = arm::control_torque;
};

using State = servo::StateOf<Arm>;  // q and qd
using Robot = servo::SimulatedRobot<Arm>;

// What happens in every cycle: the state goes in, the torque comes out. This law holds and moves
// the pose of the tool. Write your own law into `control`.
class Law {
 public:
  explicit Law(const State& at_rest)  // gains in 1/s^2 and 1/s: critically damped
      : pose_({400, 40}, servo::posture_gains<Arm>(at_rest.q, {25, 10})) {}

  void start(double time, const State& state) { pose_.start(time, state); }
  void apply(double time, const servo::Message& message) { pose_.apply(time, message); }
  void control(double time, const State& state, double (&tau)[Arm::kVelocities]) {
    pose_.control(time, state, tau);
  }

  // Desired and actual pose of operational point 0.
  const auto& tool() const { return pose_.tracking(0); }

 private:
  servo::PoseTaskController<Arm> pose_;
};

// The limits of the URDF. The loop brakes the arm when one is exceeded.
auto limits() {
  return servo::limits_of(arm::kLowerLimits, arm::kUpperLimits, arm::kVelocityLimits,
                          arm::kEffortLimits);
}

// Asks for the pose that the tool has where each joint is a little nearer to the middle of its
// range: by 0.2 rad, or less where its range or speed is small. The tool goes there on a straight
// line in two seconds.
servo::Message move_tool(const State& from) {
  double q[Arm::kCoordinates];
  for (int i = 0; i < Arm::kCoordinates; ++i) {
    const double range = arm::kUpperLimits[i] - arm::kLowerLimits[i];
    const double middle = arm::kLowerLimits[i] + 0.5 * range;
    const double step = std::min({0.2, 0.1 * range, 0.3 * arm::kVelocityLimits[i]});
    q[i] = from.q[i] + std::copysign(step, middle - from.q[i]);
  }
  double positions[3 * servo::kTaskPoints<Arm>];
  double rotations[9 * servo::kTaskPoints<Arm>];
  arm::forward_kinematics(q, positions, rotations);
  servo::Message message;
  message.kind = servo::MessageKind::move_point;
  message.index = 0;  // operational point
  message.duration = 2.0;
  std::copy(positions, positions + 3, message.values.begin());
  std::copy(rotations, rotations + 9, message.values.begin() + 3);
  return message;
}

template <class Clock>
int reach(Clock& clock) {
  const State at_rest = servo::bent_pose<Arm>(arm::kHome, limits());
  Robot robot(at_rest);
  Law law(at_rest);
  servo::Mailbox mailbox;
  auto loop = std::make_unique<servo::ServoLoop<Arm, Robot, Law, Clock>>(
      servo::LoopSettings{}, limits(), robot, law, clock, mailbox);

  servo::Message start;
  start.kind = servo::MessageKind::start;
  mailbox.push(start);
  bool moving = false;
  bool leaving = false;
  double begin[3] = {};
  double worst = 0.0;
  loop->run([&](const servo::Report<Arm>& report) {  // called in every cycle
    if (!moving && report.time > 0.5) {
      std::copy_n(law.tool().position, 3, begin);
      moving = mailbox.push(move_tool(report.state));
    }
    if (!leaving && report.time > 3.0) {
      servo::Message leave;
      leave.kind = servo::MessageKind::disconnect;
      leaving = mailbox.push(leave);
    }
    for (const servo::TaskRow& row : servo::task_rows(arm::kTaskRowNames)) {
      if (row.point == 0 && row.axis < 3) {
        worst = std::max(worst, std::fabs(law.tool().error[row.axis]));
      }
    }
  });

  const double* tool = law.tool().position;
  const double way = std::hypot(tool[0] - begin[0], tool[1] - begin[1], tool[2] - begin[2]);
  std::printf("tool moved by %.4f m to (%.4f, %.4f, %.4f) m, largest position error %.1e m\n", way,
              tool[0], tool[1], tool[2], worst);
  std::printf("control %.1f us at the median, %.1f us at most; lateness %.1f us at the median\n",
              1e-3 * loop->control_times().median(), 1e-3 * loop->control_times().maximum(),
              1e-3 * loop->cycle().jitters().median());
  if (const servo::Fault& fault = loop->fault()) {
    const char* joint = fault.index < 0 ? "" : arm::kVelocityJoints[fault.index];
    std::printf("stopped: %s\n", servo::describe(fault, joint).c_str());
  }
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
