#include "trot.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "anymal_simulated_joints.hpp"
#include "servo/run_for.hpp"
#include "trot_controller.hpp"

namespace treeline::experiments {
namespace {

namespace robot = anymal_simulated;
using Robot = servo::RobotOnGround<AnymalOnFeet>;
using Limits = servo::SafetyLimits<robot::kCoordinates, robot::kVelocities>;
constexpr int kRates = robot::kVelocities;
constexpr int kSubsteps = 8;
constexpr int kRecordEvery = 10;  ///< cycles

/// Legs bent by as much as ANYmal's usual stance, fore and hind knees towards each other.
AnymalState initial_state() {
  constexpr double kHip = 0.4, kKnee = -0.8;
  AnymalState state{};
  state.q[6] = 1.0;
  for (int foot = 0; foot < kFeet; ++foot) {
    const double sign = foot < 2 ? 1.0 : -1.0;
    state.q[7 + 3 * foot + 1] = sign * kHip;
    state.q[7 + 3 * foot + 2] = sign * kKnee;
  }
  AnymalOnFeet::Vectors feet;
  AnymalOnFeet::place_feet(state.q, feet);
  state.q[2] = -feet[0][2] - weight_of_anymal() / (kFeet * servo::GroundMaterial{}.stiffness);
  return state;
}

/// Limits of the joints. The base has no motor: any torque at it is a fault.
Limits limits_of_anymal() {
  Limits limits = servo::limits_of(robot::kLowerLimits, robot::kUpperLimits, robot::kVelocityLimits,
                                   robot::kEffortLimits);
  std::fill_n(limits.torque.begin(), 6, 0.0);
  return limits;
}

std::vector<std::string> column_names() {
  std::vector<std::string> names = {"time", "wanted_way", "speed", "tilt", "torque", "iterations"};
  for (const char* foot : {"left_fore", "right_fore", "left_hind", "right_hind"}) {
    names.push_back(std::string(foot) + "_load");
    names.push_back(std::string(foot) + "_height");
  }
  return report::with_coordinates(std::move(names), robot::kCoordinates);
}

/// The experiment around the loop.
class Trotting {
 public:
  explicit Trotting(const TrotPlan& plan)
      : plan_(plan),
        simulated_(initial_state(), kSubsteps, {0}),
        controller_(plan),
        run_{report::Table(column_names(),
                           static_cast<std::size_t>(plan.duration() * 1e3) / kRecordEvery + 2),
             {},
             {}} {}

  TrotRun run() {
    servo::SimulatedClock clock;
    servo::Mailbox mailbox;
    const auto watch = [this](const servo::Report<AnymalOnFeet>& report) { look_at(report); };
    const servo::RunEnd end =
        servo::run_for<AnymalOnFeet>(plan_.duration(), servo::LoopSettings{}, limits_of_anymal(),
                                     simulated_, controller_, clock, mailbox, watch);
    run_.fault = end.fault;
    run_.figures.slipped = simulated_.slipped();
    return std::move(run_);
  }

 private:
  void look_at(const servo::Report<AnymalOnFeet>& report) {
    run_.figures.add(controller_.last().within);
    if (controller_.last().phase.step < 0) start_ = report.state;
    look_at_robot(report.state);
    if (cycles_++ % kRecordEvery == 0) record(report);
  }

  void look_at_robot(const AnymalState& state) {
    TrotFigures& figures = run_.figures;
    const TrotCommand& command = controller_.last();
    tilt_ = 2.0 * std::asin(std::min(1.0, std::hypot(state.q[3], state.q[4])));
    figures.tilt = std::max(figures.tilt, tilt_);
    figures.height = std::max(figures.height, std::fabs(command.away[2]));
    figures.away = std::max(figures.away, std::hypot(command.away[0], command.away[1]));
    figures.swing_error = std::max(figures.swing_error, command.swing_error);
    figures.beyond_in_part = std::max(figures.beyond_in_part, command.beyond_in_part);
    if (cycles_ > 0) figures.torque_step = std::max(figures.torque_step, command.torque_step);
    figures.way = state.q[0] - start_.q[0];
    figures.aside = state.q[1] - start_.q[1];
    figures.end_speed = 0.0;
    for (int i = 0; i < kRates; ++i) {
      const double speed = std::fabs(state.qd[i]);
      figures.end_speed = std::max(figures.end_speed, speed);
      if (i >= 6) figures.speed = std::max(figures.speed, speed / robot::kVelocityLimits[i]);
    }
    count_step(state);
  }

  /// A step counts once both feet that swing are in the air, each by half of its lift or more.
  void count_step(const AnymalState& state) {
    const TrotPhase& phase = controller_.last().phase;
    AnymalOnFeet::place_feet(state.q, feet_);
    loads_ = simulated_.ground_forces();
    if (phase.support == Support::all || phase.step == counted_) return;
    for (std::size_t foot = 0; foot < feet_.size(); ++foot) {
      if (carries(phase.support, static_cast<int>(foot))) continue;
      if (feet_[foot][2] < 0.5 * plan_.lift || loads_[foot][2] > 0.0) return;
    }
    counted_ = phase.step;
    ++run_.figures.steps;
  }

  void record(const servo::Report<AnymalOnFeet>& report) {
    const double since = report.time;
    std::vector<double> row = {since,
                               way_at(plan_, since).position[0],
                               report.state.qd[0],
                               tilt_,
                               controller_.last().within.torque,
                               static_cast<double>(controller_.last().within.iterations)};
    for (std::size_t foot = 0; foot < feet_.size(); ++foot) {
      row.push_back(loads_[foot][2]);
      row.push_back(feet_[foot][2]);
    }
    row.insert(row.end(), std::begin(report.state.q), std::end(report.state.q));
    run_.table.append(row.data());
  }

  TrotPlan plan_;
  Robot simulated_;
  TrotController controller_;
  TrotRun run_;
  AnymalState start_{};
  AnymalOnFeet::Vectors feet_{}, loads_{};
  double tilt_ = 0.0;
  int counted_ = -1;
  long cycles_ = 0;
};

}  // namespace

TrotRun run_trot(const TrotPlan& plan) {
  return Trotting(plan).run();
}

}  // namespace treeline::experiments
