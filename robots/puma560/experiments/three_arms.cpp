#include "three_arms.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/command_laws.hpp"
#include "core/orientation.hpp"
#include "puma_trio.hpp"
#include "puma_trio_joints.hpp"
#include "servo/loop.hpp"
#include "servo/pose_reference.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {
namespace {

constexpr int kArms = 3;
constexpr int kDrift = 6 * (kArms - 1);
constexpr int kInternal = 6 * (kArms - 1);
/// Critically damped, with rates of 50 /s.
constexpr double kStabilisation[2] = {100.0, 2500.0};
constexpr double kStart[6] = {0.0, -0.9, 2.9, 0.0, 1.1415926535897931, 0.0};  ///< of each arm

/// The generated functions in the form that the servo library expects of a robot: the three arms
/// with the beam. The torque that holds them at rest also holds the beam.
struct ArmsWithBeam {
  static constexpr int kCoordinates = puma_trio::kCoordinates;
  static constexpr int kVelocities = puma_trio::kVelocities;

  static void inverse_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&qdd)[kVelocities],
                               double (&tau)[kVelocities]) noexcept {
    const double rest[6] = {};
    const double none[kInternal] = {};
    puma_trio::object_control_torque(q, qd, qdd, rest, none, tau);
  }
  static void forward_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&tau)[kVelocities],
                               double (&qdd)[kVelocities]) noexcept {
    double xdd[6], forces[6 * kArms], internal[kInternal];
    puma_trio::object_forward_dynamics(q, qd, tau, kStabilisation, qdd, xdd, forces, internal);
  }
};
using State = servo::StateOf<ArmsWithBeam>;
constexpr int nv = ArmsWithBeam::kVelocities;

enum Column : std::size_t {
  kTime,
  kWanted,
  kActual = kWanted + 3,
  kErrors = kActual + 3,
  kDriftSize = kErrors + 2,
  kActing,
  kCommanded = kActing + 4,
  kColumns = kCommanded + 4
};

/// Operational-space control of the beam (Chang table 7.1) with commanded internal forces. Eighteen
/// joints for eighteen rows leave no posture to advise.
class BeamController {
 public:
  explicit BeamController(const ThreeArmsPlan& plan) : gains_{plan.stiffness, plan.damping} {
    std::copy(std::begin(plan.tensions), std::end(plan.tensions), internal);
  }

  void start(double, const State& state) noexcept {
    observe(state);
    reference_.hold(position, rotation);
  }
  void apply(double time, const servo::Message& message) noexcept {
    if (message.kind != servo::MessageKind::move_point || !(message.duration > 0.0)) return;
    double to[3], turned[9];
    std::copy(message.values.begin(), message.values.begin() + 3, to);
    std::copy(message.values.begin() + 3, message.values.begin() + 12, turned);
    const servo::PoseMotion from = reference_.at(time);
    reference_.move(time, from.position, from.rotation, to, turned, message.duration);
  }
  void control(double time, const State& state, double (&tau)[nv]) noexcept {
    observe(state);
    wanted = reference_.at(time);
    core::pose_error(position, rotation, wanted.position, wanted.rotation, error);
    double xdd[6];
    core::tracking_law(gains_, error, velocity_, wanted.velocity, wanted.acceleration, xdd);
    const double rest[nv] = {};
    puma_trio::object_control_torque(state.q, state.qd, rest, xdd, internal, tau);
  }

  /// As of the last call of `control`.
  servo::PoseMotion wanted;
  double position[3] = {}, rotation[9] = {}, error[6] = {}, drift[kDrift] = {};
  double internal[kInternal] = {};  ///< commanded

 private:
  void observe(const State& state) noexcept {
    double drift_rate[kDrift];
    puma_trio::object_state(state.q, state.qd, position, rotation, velocity_, drift, drift_rate);
  }

  core::Gains<double> gains_;
  servo::PoseReference reference_;
  double velocity_[6] = {};
};

double norm(const double* v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

double largest_of(const double* values, int count) {
  double largest = 0.0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, std::abs(values[i]));
  return largest;
}

/// Appends a cycle. Forces are those at its beginning under `held`, the torque of the cycle before.
void record(const servo::Report<ArmsWithBeam>& report, const BeamController& controller,
            const double (&held)[nv], servo::Table& table) {
  double qdd[nv], xdd[6], forces[6 * kArms], internal[kInternal];
  puma_trio::object_forward_dynamics(report.state.q, report.state.qd, held, kStabilisation, qdd,
                                     xdd, forces, internal);
  double row[kColumns];
  row[kTime] = report.time;
  std::copy(std::begin(controller.wanted.position), std::end(controller.wanted.position),
            row + kWanted);
  std::copy(std::begin(controller.position), std::end(controller.position), row + kActual);
  row[kErrors] = norm(controller.error);
  row[kErrors + 1] = norm(controller.error + 3);
  row[kDriftSize] = largest_of(controller.drift, kDrift);
  for (std::size_t i = 0; i < 3; ++i) {
    row[kActing + i] = internal[i];
    row[kCommanded + i] = controller.internal[i];
  }
  row[kActing + 3] = largest_of(internal + 3, kInternal - 3);
  row[kCommanded + 3] = 0.0;
  table.append(row);
}

servo::SafetyLimits<ArmsWithBeam::kCoordinates, nv> limits_of_arms() {
  servo::SafetyLimits<ArmsWithBeam::kCoordinates, nv> limits;
  std::copy(std::begin(puma_trio::kLowerLimits), std::end(puma_trio::kLowerLimits),
            limits.lower.begin());
  std::copy(std::begin(puma_trio::kUpperLimits), std::end(puma_trio::kUpperLimits),
            limits.upper.begin());
  std::copy(std::begin(puma_trio::kVelocityLimits), std::end(puma_trio::kVelocityLimits),
            limits.velocity.begin());
  std::copy(std::begin(puma_trio::kEffortLimits), std::end(puma_trio::kEffortLimits),
            limits.torque.begin());
  return limits;
}

State start_state() {
  State state;
  for (int i = 0; i < ArmsWithBeam::kCoordinates; ++i) state.q[i] = kStart[i % 6];
  return state;
}

/// Moves the beam to where it was at the start, shifted and turned by this share of the plan.
servo::Message move_message(const ThreeArmsPlan& plan, double share) {
  const State start = start_state();
  double position[3], rotation[9], velocity[6], drift[kDrift], rate[kDrift];
  puma_trio::object_state(start.q, start.qd, position, rotation, velocity, drift, rate);
  const double vector[3] = {0.0, 0.0, share * plan.turn};
  double turned[9];
  core::rotation_from_vector(vector, turned);
  servo::Message message;
  message.kind = servo::MessageKind::move_point;
  message.index = 0;
  message.duration = plan.duration;
  for (std::size_t i = 0; i < 3; ++i) message.values[i] = position[i] + share * plan.shift[i];
  std::copy(std::begin(turned), std::end(turned), message.values.begin() + 3);
  return message;
}

servo::Message message_of(servo::MessageKind kind) {
  servo::Message message;
  message.kind = kind;
  return message;
}

double largest(const servo::Table& table, std::size_t column) {
  const auto values = table.column(column);
  return largest_of(values.data(), static_cast<int>(values.size()));
}

}  // namespace

ThreeArmsOutcome::ThreeArmsOutcome(std::size_t rows)
    : table({"time", "x_wanted", "y_wanted", "z_wanted", "x", "y", "z", "position_error",
             "rotation_error", "drift", "tension_12", "tension_23", "tension_31", "largest_moment",
             "tension_12_commanded", "tension_23_commanded", "tension_31_commanded",
             "moments_commanded"},
            rows) {}

ThreeArmsOutcome carry_with_three_arms(const ThreeArmsPlan& plan) {
  using Robot = servo::SimulatedRobot<ArmsWithBeam>;
  Robot robot(start_state(), plan.substeps);
  BeamController controller(plan);
  servo::Mailbox mailbox;
  servo::SimulatedClock clock;
  servo::LoopSettings settings;
  settings.rate = plan.rate;
  auto loop = std::make_unique<
      servo::ServoLoop<ArmsWithBeam, Robot, BeamController, servo::SimulatedClock>>(
      settings, limits_of_arms(), robot, controller, clock, mailbox);
  const double back = 2.0 * plan.lead + plan.duration;
  const double total = back + plan.duration + plan.lead;
  ThreeArmsOutcome outcome(static_cast<std::size_t>(total * plan.rate) + 2);
  const std::array<std::pair<double, servo::Message>, 3> script = {
      {{plan.lead, move_message(plan, 1.0)},
       {back, move_message(plan, 0.0)},
       {total, message_of(servo::MessageKind::disconnect)}}};
  std::size_t next = 0;
  double held[nv] = {};
  bool holding = false;
  mailbox.push(message_of(servo::MessageKind::start));
  loop->run([&](const servo::Report<ArmsWithBeam>& report) {
    if (report.mode == servo::Mode::running) {
      record(report, controller, holding ? held : report.tau, outcome.table);
      std::copy(std::begin(report.tau), std::end(report.tau), held);
      holding = true;
    }
    const bool faulted = report.mode == servo::Mode::faulted;
    if (faulted && next < script.size()) next = script.size() - 1;
    if (next < script.size() && (faulted || report.time >= script[next].first) &&
        mailbox.push(script[next].second)) {
      ++next;
    }
  });
  outcome.fault = loop->fault();
  outcome.control = loop->control_times();
  return outcome;
}

ThreeArmsErrors largest_errors(const ThreeArmsOutcome& outcome) {
  const servo::Table& table = outcome.table;
  ThreeArmsErrors errors;
  errors.position = largest(table, kErrors);
  errors.rotation = largest(table, kErrors + 1);
  errors.drift = largest(table, kDriftSize);
  errors.moments = largest(table, kActing + 3);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      errors.tensions = std::max(
          errors.tensions, std::abs(table.at(row, kActing + i) - table.at(row, kCommanded + i)));
    }
    errors.lift = std::max(errors.lift, table.at(row, kActual + 2) - table.at(0, kActual + 2));
  }
  return errors;
}

bool within_bounds(const ThreeArmsOutcome& outcome) {
  const ThreeArmsErrors errors = largest_errors(outcome);
  return !outcome.fault && errors.position < 1e-4 && errors.rotation < 1e-3 &&
         errors.tensions < 0.1 && errors.moments < 0.1 && errors.drift < 1e-9 && errors.lift > 0.09;
}

std::string summary(const ThreeArmsOutcome& outcome) {
  const ThreeArmsErrors errors = largest_errors(outcome);
  const servo::DurationStatistics& control = outcome.control;
  const int index = outcome.fault.index;
  const std::string fault =
      outcome.fault ? "stopped      " +
                          servo::describe(outcome.fault,
                                          index >= 0 ? puma_trio::kCoordinateJoints[index] : "") +
                          "\n"
                    : std::string();
  return fault +
         fmt::format(
             "beam         largest tracking error {:.2e} m, {:.2e} rad (bounds 1e-4, 1e-3), lifted "
             "{:.3f} m\n"
             "internal     tensions off by at most {:.2e} N, moments by {:.2e} N m (bounds 0.1)\n"
             "drift        between the grasps {:.2e} (bound 1e-9)\n"
             "control      of three arms: median {:.2f} us, 99 % {:.2f} us over {} cycles\n"
             "bounds       {}\n",
             errors.position, errors.rotation, errors.lift, errors.tensions, errors.moments,
             errors.drift, 1e-3 * control.median(), 1e-3 * control.quantile(0.99), control.count(),
             within_bounds(outcome) ? "kept" : "BROKEN");
}

servo::Plot figure(const ThreeArmsOutcome& outcome) {
  const servo::Table& table = outcome.table;
  servo::Plot plot;
  plot.title = "Three arms carry one beam (Chang section 7.2)";
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  constexpr std::array kNames = {"x", "y", "z"};
  constexpr std::array kRods = {"rod 12", "rod 23", "rod 31"};
  servo::PlotPanel beam{"Beam", "position (m)", {}, 0.1};
  servo::PlotPanel tensions{"Internal forces: tensions", "force (N)", {}, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    beam.lines.push_back({kNames[i], table.column(kActual + i), false});
    tensions.lines.push_back({kRods[i], table.column(kActing + i), false});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    beam.lines.push_back({i == 0 ? "wanted" : "", table.column(kWanted + i), true});
    tensions.lines.push_back({i == 0 ? "commanded" : "", table.column(kCommanded + i), true});
  }
  std::vector<double> error = table.column(kErrors);
  for (double& value : error) value *= 1e6;
  plot.panels.push_back(std::move(beam));
  plot.panels.push_back({"Distance between wanted and actual position",
                         "distance (\u00b5m)",
                         {{"beam", error, false}},
                         0.0});
  plot.panels.push_back(std::move(tensions));
  return plot;
}

}  // namespace treeline::experiments
