#include "carry_ladder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "close_grasp.hpp"
#include "humanoid_pair.hpp"
#include "humanoid_pair_joints.hpp"
#include "object_task_controller.hpp"
#include "robot_with_object.hpp"
#include "servo/loop.hpp"
#include "servo/safety.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {
namespace {

constexpr int kHands = 4;
constexpr int kJoints = humanoid_pair::kVelocities / 2;

struct Generated {
  static constexpr int kCoordinates = humanoid_pair::kCoordinates;
  static constexpr int kVelocities = humanoid_pair::kVelocities;
  static constexpr auto& mass_matrix = humanoid_pair::mass_matrix;
  static constexpr auto& object_state = humanoid_pair::object_state;
  static constexpr auto& object_control_torque = humanoid_pair::object_control_torque;
  static constexpr auto& object_forward_dynamics = humanoid_pair::object_forward_dynamics;
};
using Humanoids = RobotWithObject<Generated, kHands>;
using Controller = ObjectTaskController<Humanoids>;
constexpr int nv = Humanoids::kVelocities;

/// Posture of each humanoid at the start, as for `put_box`: hands before the body at 1.1 m.
constexpr double kStart[kJoints] = {0.3969,  -0.9523, 0.1667, 0,       0.6163,  0,
                                    -1.2661, -0.1319, 0.0595, -0.5180, 0.0329,  1.0512,
                                    0.1723,  -1.2662, 0.1319, -0.0594, -0.5180, -0.0330,
                                    1.0512,  -0.1723, 0,      0,       0,       0};
/// Springs of the posture, N m/rad: legs and waist, arms, head.
constexpr double kSprings[kJoints] = {200, 200, 200, 200, 300, 200, 20, 55, 55, 27, 5, 5,
                                      5,   20,  55,  55,  27,  5,   5,  5,  5,  5,  1, 1};

enum Column : std::size_t {
  kTime,
  kWanted,
  kActual = kWanted + 3,
  kErrors = kActual + 3,
  kDriftSize = kErrors + 2,
  kSqueeze,
  kCommanded = kSqueeze + 2,
  kInternalError,
  kCoordinates,
  kColumns = kCoordinates + Humanoids::kCoordinates
};
/// Of the virtual linkage's rods, those between the hands of one humanoid: 12 and 34.
constexpr std::array<std::size_t, 2> kOwnRods = {0, 5};

double norm(const double* v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

std::array<double, Humanoids::kInternal> commanded_internal(const LadderPlan& plan) {
  std::array<double, Humanoids::kInternal> internal{};
  for (const std::size_t rod : kOwnRods) internal[rod] = -plan.squeeze;
  return internal;
}

Controller make_controller(const LadderPlan& plan) {
  std::array<double, nv> springs{};
  for (std::size_t i = 0; i < springs.size(); ++i) springs[i] = kSprings[i % kJoints];
  return {{plan.stiffness, plan.damping}, springs, 1.0, commanded_internal(plan)};
}

servo::StateOf<Humanoids> start_state() {
  servo::StateOf<Humanoids> state;
  for (int i = 0; i < Humanoids::kCoordinates; ++i) state.q[i] = kStart[i % kJoints];
  close_grasp<Humanoids>(state.q);
  return state;
}

/// Moves the ladder from where it is at the start, by the plan.
servo::Message move_message(const LadderPlan& plan, const servo::StateOf<Humanoids>& start) {
  double position[3], rotation[9], velocity[6], drift[Humanoids::kDrift], rate[Humanoids::kDrift];
  humanoid_pair::object_state(start.q, start.qd, position, rotation, velocity, drift, rate);
  const double vector[3] = {0.0, 0.0, plan.turn};
  double turned[9];
  core::rotation_from_vector(vector, turned);
  servo::Message message;
  message.kind = servo::MessageKind::move_point;
  message.index = 0;
  message.duration = plan.duration;
  for (std::size_t i = 0; i < 3; ++i) message.values[i] = position[i] + plan.shift[i];
  std::copy(std::begin(turned), std::end(turned), message.values.begin() + 3);
  return message;
}

/// Appends a cycle. Forces are those at its beginning under `held`, the torque of the cycle before.
void record(const servo::Report<Humanoids>& report, const Controller& controller,
            const std::array<double, Humanoids::kInternal>& commanded, const double (&held)[nv],
            servo::Table& table) {
  double qdd[nv], xdd[6], forces[6 * kHands], internal[Humanoids::kInternal];
  humanoid_pair::object_forward_dynamics(report.state.q, report.state.qd, held, kStabilisation, qdd,
                                         xdd, forces, internal);
  const auto& tracking = controller.tracking();
  double row[kColumns] = {};
  row[kTime] = report.time;
  std::copy(std::begin(tracking.wanted.position), std::end(tracking.wanted.position),
            row + kWanted);
  std::copy(std::begin(tracking.position), std::end(tracking.position), row + kActual);
  row[kErrors] = norm(tracking.error);
  row[kErrors + 1] = norm(tracking.error + 3);
  for (const double x : tracking.drift) row[kDriftSize] = std::max(row[kDriftSize], std::abs(x));
  for (std::size_t i = 0; i < kOwnRods.size(); ++i) row[kSqueeze + i] = internal[kOwnRods[i]];
  row[kCommanded] = commanded[kOwnRods[0]];
  for (std::size_t i = 0; i < commanded.size(); ++i) {
    row[kInternalError] = std::max(row[kInternalError], std::abs(internal[i] - commanded[i]));
  }
  std::copy(std::begin(report.state.q), std::end(report.state.q), row + kCoordinates);
  table.append(row);
}

std::vector<std::string> column_names() {
  std::vector<std::string> names = {"time",
                                    "x_wanted",
                                    "y_wanted",
                                    "z_wanted",
                                    "x",
                                    "y",
                                    "z",
                                    "position_error",
                                    "rotation_error",
                                    "drift",
                                    "squeeze_first",
                                    "squeeze_second",
                                    "squeeze_commanded",
                                    "internal_error"};
  for (const char* joint : humanoid_pair::kCoordinateJoints) {
    names.push_back(std::string("q_") + joint);
  }
  return names;
}

servo::Message message_of(servo::MessageKind kind) {
  servo::Message message;
  message.kind = kind;
  return message;
}

double largest(const servo::Table& table, std::size_t column) {
  double result = 0.0;
  for (const double value : table.column(column)) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace

LadderOutcome::LadderOutcome(std::size_t rows) : table(column_names(), rows) {}

LadderOutcome carry_ladder(const LadderPlan& plan) {
  using Robot = servo::SimulatedRobot<Humanoids>;
  const servo::StateOf<Humanoids> start = start_state();
  Robot robot(start, plan.substeps);
  Controller controller = make_controller(plan);
  servo::Mailbox mailbox;
  servo::SimulatedClock clock;
  servo::LoopSettings settings;
  settings.rate = plan.rate;
  auto loop =
      std::make_unique<servo::ServoLoop<Humanoids, Robot, Controller, servo::SimulatedClock>>(
          settings,
          servo::limits_of(humanoid_pair::kLowerLimits, humanoid_pair::kUpperLimits,
                           humanoid_pair::kVelocityLimits, humanoid_pair::kEffortLimits),
          robot, controller, clock, mailbox);
  const double total = 2.0 * plan.lead + plan.duration;
  LadderOutcome outcome(static_cast<std::size_t>(total * plan.rate) + 2);
  const auto commanded = commanded_internal(plan);
  double held[nv] = {};
  bool holding = false, moving = false, leaving = false;
  mailbox.push(message_of(servo::MessageKind::start));
  loop->run([&](const servo::Report<Humanoids>& report) {
    if (report.mode == servo::Mode::running) {
      record(report, controller, commanded, holding ? held : report.tau, outcome.table);
      std::copy(std::begin(report.tau), std::end(report.tau), held);
      holding = true;
    }
    if (!moving && report.time >= plan.lead) moving = mailbox.push(move_message(plan, start));
    if (!leaving && (report.time >= total || report.mode == servo::Mode::faulted)) {
      leaving = mailbox.push(message_of(servo::MessageKind::disconnect));
    }
  });
  outcome.fault = loop->fault();
  outcome.control = loop->control_times();
  return outcome;
}

LadderErrors largest_errors(const LadderOutcome& outcome) {
  const servo::Table& table = outcome.table;
  LadderErrors errors;
  errors.position = largest(table, kErrors);
  errors.rotation = largest(table, kErrors + 1);
  errors.drift = largest(table, kDriftSize);
  errors.internal = largest(table, kInternalError);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    errors.lift = std::max(errors.lift, table.at(row, kActual + 2) - table.at(0, kActual + 2));
  }
  return errors;
}

bool within_bounds(const LadderOutcome& outcome) {
  const LadderErrors errors = largest_errors(outcome);
  return !outcome.fault && errors.position < 1e-4 && errors.rotation < 1e-3 &&
         errors.internal < 1.0 && errors.drift < 1e-9 && errors.lift > 0.07;
}

std::string summary(const LadderOutcome& outcome) {
  const LadderErrors errors = largest_errors(outcome);
  const servo::DurationStatistics& control = outcome.control;
  const int index = outcome.fault.index;
  const std::string fault =
      outcome.fault
          ? "stopped      " +
                servo::describe(outcome.fault,
                                index >= 0 ? humanoid_pair::kCoordinateJoints[index] : "") +
                "\n"
          : std::string();
  return fault +
         fmt::format(
             "ladder       largest tracking error {:.2e} m, {:.2e} rad (bounds 1e-4, 1e-3), lifted "
             "{:.3f} m\n"
             "internal     forces and moments off by at most {:.2e} (bound 1)\n"
             "drift        between the grasps {:.2e} (bound 1e-9)\n"
             "control      of both humanoids: median {:.2f} us, 99 % {:.2f} us over {} cycles\n"
             "bounds       {}\n",
             errors.position, errors.rotation, errors.lift, errors.internal, errors.drift,
             1e-3 * control.median(), 1e-3 * control.quantile(0.99), control.count(),
             within_bounds(outcome) ? "kept" : "BROKEN");
}

servo::Plot figure(const LadderOutcome& outcome) {
  const servo::Table& table = outcome.table;
  servo::Plot plot;
  plot.title = "Two humanoids carry a ladder (Chang section 7.1)";
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  constexpr std::array kNames = {"x", "y", "z"};
  servo::PlotPanel ladder{"Ladder", "position (m)", {}, 0.1};
  for (std::size_t i = 0; i < 3; ++i) {
    ladder.lines.push_back({kNames[i], table.column(kActual + i), false});
    ladder.lines.push_back({i == 0 ? "wanted" : "", table.column(kWanted + i), true});
  }
  std::vector<double> error = table.column(kErrors);
  for (double& value : error) value *= 1e6;
  plot.panels.push_back(std::move(ladder));
  plot.panels.push_back({"Distance between wanted and actual position",
                         "distance (\u00b5m)",
                         {{"ladder", error, false}},
                         0.0});
  plot.panels.push_back({"Internal forces between the hands of each",
                         "tension (N)",
                         {{"first", table.column(kSqueeze), false},
                          {"second", table.column(kSqueeze + 1), false},
                          {"commanded", table.column(kCommanded), true}},
                         1.0});
  return plot;
}

}  // namespace treeline::experiments
