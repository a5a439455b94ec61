#include "push.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "humanoid24_push_joints.hpp"
#include "push_controller.hpp"
#include "servo/loop.hpp"

namespace treeline::experiments {
namespace {

namespace robot = humanoid24_push;
using Robot = servo::RobotOnGround<HumanoidOnSoles>;
using Limits = servo::SafetyLimits<robot::kCoordinates, robot::kVelocities>;

constexpr double kDuration = 23.0;  ///< s
/// A push on the chest.
struct Push {
  double time;                  ///< s
  std::array<double, 3> force;  ///< N, world axes
};
constexpr double kPushTime = 0.1;  ///< s
constexpr Push kPushes[] = {
    {kFirstPush, {200.0, 0.0, 0.0}}, {16.0, {-200.0, 0.0, 0.0}}, {19.0, {0.0, 130.0, 0.0}}};
constexpr const char* kColumns[] = {"time",       "com_x",     "com_y",      "pressure_x",
                                    "pressure_y", "left_load", "right_load", "hand_error",
                                    "torque",     "push",      "tilt",       "iterations"};

// Joints in the generated code's order.
constexpr int kAnkle = 0, kKnee = 1, kHip = 2, kLeftRoll = 7, kLeftElbow = 9, kRightRoll = 14,
              kRightElbow = 16;
constexpr double kSpread = 0.3;  ///< of the arms, which hips would touch in leaning, rad

HumanoidState initial_state() {
  HumanoidState state{};
  state.q[2] = -75.0 * 9.81 / (8.0 * servo::GroundMaterial{}.stiffness);
  state.q[6] = 1.0;
  double* joints = state.q + 7;
  joints[kAnkle] = 0.25;
  joints[kKnee] = -0.45;
  joints[kHip] = 0.2;
  joints[kLeftElbow] = joints[kRightElbow] = -0.8;
  joints[kLeftRoll] = kSpread;
  joints[kRightRoll] = -kSpread;
  return state;
}

/// Limits of the joints. The base has no motor: any torque at it is a fault.
Limits limits_of_humanoid() {
  Limits limits = servo::limits_of(robot::kLowerLimits, robot::kUpperLimits, robot::kVelocityLimits,
                                   robot::kEffortLimits);
  std::fill_n(limits.torque.begin(), 6, 0.0);
  return limits;
}

std::array<double, 3> push_at(double time) {
  for (const Push& push : kPushes) {
    if (time >= push.time && time < push.time + kPushTime) return push.force;
  }
  return {};
}

/// How the soles stand on the ground.
struct Stance {
  double pressure[2] = {};  ///< centre of pressure of both feet, m
  double loads[2] = {};     ///< N
  double tilt = 0.0;        ///< rad
  double lifted = 0.0;      ///< m
};

Stance look_at_soles(const Robot& simulated, const HumanoidState& state) {
  Stance stance;
  HumanoidOnSoles::Vectors x, v;
  HumanoidOnSoles::ground_points(state.q, state.qd, x, v);
  const HumanoidOnSoles::Vectors forces = simulated.ground_forces();
  double moments[2] = {};
  for (std::size_t i = 0; i < x.size(); ++i) {
    stance.loads[i / 4] += forces[i][2];
    for (std::size_t k = 0; k < 2; ++k) moments[k] += forces[i][2] * x[i][k];
    stance.lifted = std::max(stance.lifted, x[i][2]);
  }
  const double load = stance.loads[0] + stance.loads[1];
  for (std::size_t k = 0; k < 2 && load > 0.0; ++k) stance.pressure[k] = moments[k] / load;
  stance.tilt = 2.0 * std::asin(std::min(1.0, std::hypot(state.q[3], state.q[4])));
  return stance;
}

void look_at_robot(double time, const PushController& controller, const HumanoidState& state,
                   const Stance& stance, const double (&rest)[3], PushFigures& figures) {
  const bool pushed = time >= kPushes[0].time;
  const double(&com)[3] = controller.center_of_mass();
  figures.tilt = std::max(figures.tilt, stance.tilt);
  figures.lifted = std::max(figures.lifted, stance.lifted);
  const double share = stance.loads[0] / (stance.loads[0] + stance.loads[1]);
  if (!pushed) {
    figures.least_share = std::min(figures.least_share, share);
    figures.most_share = std::max(figures.most_share, share);
  }
  double& hand = pushed ? figures.hand_pushed : figures.hand_error;
  hand = std::max(hand, controller.hand_error());
  figures.end_away = std::hypot(com[0] - rest[0], com[1] - rest[1]);
  if (pushed) figures.away = std::max(figures.away, figures.end_away);
  figures.end_speed = 0.0;
  for (const double rate : state.qd) {
    figures.end_speed = std::max(figures.end_speed, std::fabs(rate));
  }
}

/// The experiment around the loop.
class Pushing {
 public:
  explicit Pushing(bool within_limits)
      : simulated_(initial_state(), 8, {0}),
        controller_(within_limits),
        loop_(std::make_unique<Loop>(servo::LoopSettings{}, limits_of_humanoid(), simulated_,
                                     controller_, clock_, mailbox_)),
        run_{report::Table(report::with_coordinates({std::begin(kColumns), std::end(kColumns)},
                                                    robot::kCoordinates),
                           static_cast<std::size_t>(kDuration * 1e3) + 1),
             {},
             {}} {}

  PushRun run() {
    servo::Message start;
    start.kind = servo::MessageKind::start;
    mailbox_.push(start);
    bool running = true;
    while (running && loop_->time() < kDuration) {
      simulated_.push(push_at(loop_->time()));
      running = loop_->step([this](const servo::Report<HumanoidOnSoles>& report) {
        record(report);
      }) && !loop_->fault();
    }
    run_.fault = loop_->fault();
    run_.figures.slipped = simulated_.slipped();
    return std::move(run_);
  }

 private:
  using Loop = servo::ServoLoop<HumanoidOnSoles, Robot, PushController, servo::SimulatedClock>;

  void record(const servo::Report<HumanoidOnSoles>& report) {
    if (report.mode != servo::Mode::running) return;
    const double(&com)[3] = controller_.center_of_mass();
    if (run_.table.rows() == 0) std::copy(std::begin(com), std::end(com), rest_);
    const Stance stance = look_at_soles(simulated_, report.state);
    run_.figures.add(limit_figures(report.tau, robot::kEffortLimits, controller_.forces(),
                                   robot::kTorqueLimits, controller_.limited()));
    look_at_robot(report.time, controller_, report.state, stance, rest_, run_.figures);
    const std::array<double, 3> push = push_at(report.time);
    double row[std::size(kColumns) + robot::kCoordinates] = {
        report.time,
        com[0],
        com[1],
        stance.pressure[0],
        stance.pressure[1],
        stance.loads[0],
        stance.loads[1],
        controller_.hand_error(),
        largest_share(report.tau, robot::kEffortLimits),
        push[0] + push[1],
        stance.tilt,
        static_cast<double>(controller_.limited().iterations)};
    std::copy(std::begin(report.state.q), std::end(report.state.q), row + std::size(kColumns));
    run_.table.append(row);
  }

  Robot simulated_;
  PushController controller_;
  servo::Mailbox mailbox_;
  servo::SimulatedClock clock_;
  std::unique_ptr<Loop> loop_;
  PushRun run_;
  double rest_[3] = {};
};

}  // namespace

PushRun run_push(bool within_limits) {
  return Pushing(within_limits).run();
}

}  // namespace treeline::experiments
