#include "press_surface.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/command_laws.hpp"
#include "core/task_selection.hpp"
#include "puma560.hpp"
#include "puma560_joints.hpp"
#include "servo/clock.hpp"
#include "servo/integrate.hpp"
#include "servo/run_for.hpp"
#include "servo/safety.hpp"

namespace treeline::experiments {
namespace {

struct Puma {
  static constexpr int kCoordinates = puma560::kCoordinates;
  static constexpr int kVelocities = puma560::kVelocities;
  static constexpr auto& inverse_dynamics = puma560::inverse_dynamics;
  static constexpr auto& forward_dynamics = puma560::forward_dynamics;
};
using State = servo::StateOf<Puma>;

constexpr double kPeriod = 1e-3;       ///< s
constexpr double kDuration = 8.0;      ///< s
constexpr double kRest = 1.0;          ///< time until the plate moves, s
constexpr double kStiffness = 1e4;     ///< of the plate, N/m
constexpr double kSpringDamping = 50;  ///< N s/m
constexpr double kRadius = 0.05;       ///< of the circle, m
constexpr int kSubsteps = 10;
constexpr core::Gains<double> kMotion{400.0, 40.0};
constexpr core::ForceGains<double> kForce{1.0, 20.0, 60.0};
constexpr std::size_t kColumns = 19;

/// The plate and the flange's desired place on it; world axes.
struct Plate {
  double position[3] = {};
  double rotation[9] = {};  ///< its z axis is the normal
  double velocity[6] = {};  ///< of `position`, and angular velocity
  double turn_rate = 0.0;   ///< about y, rad/s^2
  double place[3] = {};     ///< of the flange, m
};

/// State of the plate. It rocks about y and heaves along z; the flange's place moves on it in a
/// circle.
Plate plate_at(double time, const double (&origin)[3]) {
  const double t = std::max(time - kRest, 0.0);
  const double turn[3] = {0.0, 0.175 * (1.0 - std::cos(1.5 * t)), 0.0};
  Plate plate;
  std::copy(std::begin(origin), std::end(origin), plate.position);
  plate.position[2] += 0.02 * (1.0 - std::cos(2.0 * t));
  plate.velocity[2] = 0.04 * std::sin(2.0 * t);
  plate.velocity[4] = 0.175 * 1.5 * std::sin(1.5 * t);
  plate.turn_rate = t > 0.0 ? 0.175 * 1.5 * 1.5 * std::cos(1.5 * t) : 0.0;
  core::rotation_from_vector(turn, plate.rotation);
  const double phase = t - std::sin(t);
  const double in_plate[2] = {kRadius * (std::cos(phase) - 1.0), kRadius * std::sin(phase)};
  for (int i = 0; i < 3; ++i) {
    plate.place[i] = plate.position[i] + plate.rotation[3 * i] * in_plate[0] +
                     plate.rotation[3 * i + 1] * in_plate[1];
  }
  return plate;
}

/// Pose and velocity of the flange.
struct Tool {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
  double J[36] = {};
};

Tool tool_of(const State& state) {
  Tool tool;
  puma560::forward_kinematics(state.q, tool.position, tool.rotation);
  puma560::jacobian(state.q, tool.J);
  for (int i = 0; i < 36; ++i) {
    tool.velocity[i / 6] += tool.J[i] * state.qd[i % 6];
  }
  return tool;
}

/// Force on the flange along the plate's normal, by a spring and a damper that cannot pull.
double plate_force(const Plate& plate, const Tool& tool) {
  const double* w = plate.velocity + 3;
  double r[3];
  for (int i = 0; i < 3; ++i) {
    r[i] = tool.position[i] - plate.position[i];
  }
  const double carried[3] = {w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2],
                             w[0] * r[1] - w[1] * r[0]};
  double height = 0.0;
  double rate = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double n = plate.rotation[3 * i + 2];
    height += n * r[i];
    rate += n * (tool.velocity[i] - plate.velocity[i] - carried[i]);
  }
  return height < 0.0 ? std::max(-kStiffness * height - kSpringDamping * rate, 0.0) : 0.0;
}

double wanted_force(double time) {
  const auto from_to = [time](double begin, double end) {
    return core::smooth_step((time - begin) / (end - begin));
  };
  return 10.0 * from_to(0.0, 0.5) + 10.0 * from_to(4.0, 5.0);
}

/// Figures of one cycle.
struct Cycle {
  double felt = 0.0;
  double slide[3] = {};  ///< distance from the desired place within the plate, m
  double tilt[3] = {};
};

/// The robot in contact with the plate, and its sensors: encoders and a force sensor at the flange.
class PressingRobot {
 public:
  PressingRobot(const State& state, const double (&origin)[3]) : state_(state) {
    std::copy(std::begin(origin), std::end(origin), origin_);
  }

  [[nodiscard]] bool connected() const noexcept { return true; }
  void read(State& state) noexcept { state = state_; }
  void write(const double (&tau)[6]) noexcept {
    std::copy(std::begin(tau), std::end(tau), std::begin(tau_));
  }
  /// The plate's force is updated in every substep.
  void pass_time(double seconds) noexcept {
    const double step = seconds / kSubsteps;
    for (int i = 0; i < kSubsteps; ++i) {
      const Plate plate = plate_at(time_ + i * step, origin_);
      const Tool tool = tool_of(state_);
      const double force = plate_force(plate, tool);
      double driven[6];
      for (int k = 0; k < 6; ++k) {
        driven[k] = tau_[k];
        for (int row = 0; row < 3; ++row) {
          driven[k] += tool.J[6 * row + k] * force * plate.rotation[3 * row + 2];
        }
      }
      servo::integrate_runge_kutta<Puma>({}, driven, step, state_);
    }
    time_ += seconds;
  }

  /// What the force sensor reads: the force of the flange on the plate, world axes, N.
  void read_force(double (&force)[3]) const noexcept {
    const Plate plate = plate_at(time_, origin_);
    const double felt = plate_force(plate, tool_of(state_));
    for (int i = 0; i < 3; ++i) {
      force[i] = -felt * plate.rotation[3 * i + 2];
    }
  }

 private:
  State state_;
  double origin_[3] = {};
  double tau_[6] = {};
  double time_ = 0.0;
};

/// The controller. It knows where the plate is, and has the force from the robot's sensor.
class PressController {
 public:
  PressController(Frame frame, const Tool& start, const PressingRobot& robot)
      : frame_(frame), robot_(robot) {
    std::copy(std::begin(start.position), std::end(start.position), origin_);
    std::copy(std::begin(start.rotation), std::end(start.rotation), flat_);
  }

  [[nodiscard]] Plate plate(double time) const { return plate_at(time, origin_); }
  /// What the last call of `control` came to.
  [[nodiscard]] const Cycle& cycle() const { return cycle_; }

  void start(double, const State&) noexcept {}
  void apply(double, const servo::Message&) noexcept {}

  void control(double time, const State& state, double (&tau)[6]) noexcept {
    const Tool tool = tool_of(state);
    const Plate here = plate(time);
    double sensed[6] = {};
    read_force(here, sensed);
    double motion[6];
    double relative[6];
    motion_command(time, here, tool, motion, relative);
    core::TaskSelection<double> selection;
    selection.motion[2] = false;
    if (frame_ == Frame::moving) {
      std::copy(std::begin(here.rotation), std::end(here.rotation), selection.R_force);
    }
    double wanted[6] = {};
    for (int i = 0; i < 3; ++i) {
      wanted[i] = -wanted_force(time) * selection.R_force[3 * i + 2];
    }
    double force[6];
    core::force_law(kForce, wanted, sensed, kPeriod, 10.0, integral_, force);
    double Lambda_inv[36];
    puma560::lambda_inverse(state.q, Lambda_inv);
    double xdd_cmd[6];
    core::motion_force_command(selection, Lambda_inv, motion, relative, force, kForce.kv, xdd_cmd);
    const double qdd_0[6] = {};
    puma560::control_torque(state.q, state.qd, qdd_0, xdd_cmd, tau);
  }

 private:
  void read_force(const Plate& here, double (&sensed)[6]) noexcept {
    double force[3];
    robot_.read_force(force);
    cycle_.felt = 0.0;
    for (int i = 0; i < 3; ++i) {
      sensed[i] = force[i];
      cycle_.felt -= force[i] * here.rotation[3 * i + 2];
    }
  }

  /// Computes the acceleration that keeps the flange at its place and flat on the plate, and its
  /// velocity relative to the place as far as the controller knows it.
  void motion_command(double time, const Plate& here, const Tool& tool, double (&motion)[6],
                      double (&relative)[6]) noexcept {
    // The rates of the place come from differences, with a relative error of 1e-7.
    constexpr double kStep = 1e-3;
    const Plate ahead = plate(time + kStep);
    const Plate behind = plate(time - kStep);
    double velocity[6] = {};
    double acceleration[6] = {};
    for (int i = 0; i < 3; ++i) {
      velocity[i] = (ahead.place[i] - behind.place[i]) / (2.0 * kStep);
      velocity[3 + i] = here.velocity[3 + i];
      acceleration[i] = (ahead.place[i] - 2.0 * here.place[i] + behind.place[i]) / (kStep * kStep);
    }
    acceleration[4] = here.turn_rate;
    double flat[9] = {};
    for (int i = 0; i < 9; ++i) {
      for (int k = 0; k < 3; ++k) {
        flat[i] += here.rotation[i / 3 * 3 + k] * flat_[3 * k + i % 3];
      }
    }
    double error[6];
    core::pose_error(tool.position, tool.rotation, here.place, flat, error);
    core::tracking_law(kMotion, error, tool.velocity, velocity, acceleration, motion);
    double along = 0.0;
    for (int i = 0; i < 3; ++i) {
      along += here.rotation[3 * i + 2] * error[i];
    }
    for (int i = 0; i < 3; ++i) {
      cycle_.slide[i] = error[i] - along * here.rotation[3 * i + 2];
      cycle_.tilt[i] = error[3 + i];
    }
    for (int i = 0; i < 6; ++i) {
      relative[i] = tool.velocity[i] - (frame_ == Frame::moving ? velocity[i] : 0.0);
    }
  }

  Frame frame_;
  const PressingRobot& robot_;
  Cycle cycle_;
  double origin_[3] = {};
  double flat_[9] = {};  ///< rotation of the flange on the level plate
  double integral_[6] = {};
};

double norm(const double (&v)[3]) {
  return std::hypot(v[0], v[1], v[2]);
}

void record(const servo::Report<Puma>& report, const PressController& controller, PressRun& run) {
  const double time = report.time;
  const Plate plate = controller.plate(time);
  const Cycle& cycle = controller.cycle();
  const double slide = norm(cycle.slide);
  const double tilt = norm(cycle.tilt);
  const double rocked =
      2.0 * std::asin(0.5 * std::hypot(plate.rotation[2], 1.0 - plate.rotation[8]));
  double row[kColumns] = {time,   wanted_force(time), cycle.felt, slide, tilt,
                          rocked, plate.place[2]};
  PressFigures& figures = run.figures;
  for (std::size_t i = 0; i < 6; ++i) {
    row[7 + i] = report.state.q[i];
    row[13 + i] = report.tau[i];
    figures.torque = std::max(figures.torque, std::fabs(report.tau[i]) / puma560::kEffortLimits[i]);
  }
  const double first = run.table.rows() == 0 ? row[6] : run.table.at(0, 6);
  run.table.append(row);
  if (time < kRest) {
    return;
  }
  figures.force_error = std::max(figures.force_error, std::fabs(row[1] - row[2]));
  figures.slide_error = std::max(figures.slide_error, slide);
  figures.tilt_error = std::max(figures.tilt_error, tilt);
  figures.tilt = std::max(figures.tilt, rocked);
  figures.heave = std::max(figures.heave, std::fabs(row[6] - first));
  figures.lost_contact = figures.lost_contact || !(cycle.felt > 0.0);
}

std::vector<std::string> column_names() {
  std::vector<std::string> names{"time",       "force_wanted", "force",       "slide_error",
                                 "tilt_error", "plate_angle",  "plate_height"};
  for (const std::string quantity : {"q_", "tau_"}) {
    for (const char* joint : puma560::kCoordinateJoints) {
      names.push_back(quantity + joint);
    }
  }
  return names;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) {
    value *= factor;
  }
  return values;
}

}  // namespace

PressRun run_press(Frame frame) {
  State state;
  const double kDown = std::acos(-1.0);  // sum of joints 2, 3 and 5: the flange faces the floor
  const double start[6] = {0.0, -0.9, 2.9, 0.0, kDown - 2.0, 0.0};
  std::copy(std::begin(start), std::end(start), std::begin(state.q));
  const Tool tool = tool_of(state);
  PressingRobot robot(state, tool.position);
  PressController controller(frame, tool, robot);
  servo::SimulatedClock clock;
  servo::Mailbox mailbox;
  servo::LoopSettings settings;
  settings.rate = 1.0 / kPeriod;
  PressRun run{
      report::Table(column_names(), static_cast<std::size_t>(kDuration / kPeriod) + 2), {}, {}};
  run.fault = servo::run_for<Puma>(
                  kDuration, settings,
                  servo::limits_of(puma560::kLowerLimits, puma560::kUpperLimits,
                                   puma560::kVelocityLimits, puma560::kEffortLimits),
                  robot, controller, clock, mailbox,
                  [&](const servo::Report<Puma>& report) { record(report, controller, run); })
                  .fault;
  return run;
}

std::string press_summary(const PressRun& moving, const PressRun& fixed) {
  std::string text = fmt::format(
      "PUMA presses on a plate that rocks by {:.1f} degrees and carries it {:.3f} m up\n"
      "{:<24}{:>14}{:>14}{:>14}{:>14}\n",
      moving.figures.tilt * 180.0 / std::acos(-1.0), moving.figures.heave, "selection frame",
      "force off N", "circle off m", "tilt off rad", "torque/limit");
  for (const PressRun* run : {&moving, &fixed}) {
    const PressFigures& f = run->figures;
    text += fmt::format("{:<24}{:>14.3g}{:>14.2e}{:>14.2e}{:>14.3g}{}{}\n",
                        run == &moving ? "moves with the plate" : "stays as at the start",
                        f.force_error, f.slide_error, f.tilt_error, f.torque,
                        f.lost_contact ? "  contact lost" : "",
                        run->fault ? "  stopped: " + servo::describe(run->fault) : "");
  }
  return text;
}

report::Plot press_figure(const PressRun& moving, const PressRun& fixed) {
  report::Plot plot;
  plot.title = "PUMA 560 presses on a rocking plate: force control in a moving direction";
  plot.x_label = "time (s)";
  plot.x = moving.table.column(0);
  const auto compared = [&](const char* title, const char* label, std::size_t column,
                            double factor) {
    return report::PlotPanel{title,
                             label,
                             {{"frame moves", scaled(moving.table.column(column), factor), false},
                              {"frame fixed", scaled(fixed.table.column(column), factor), false}},
                             0.0};
  };
  plot.panels.push_back(compared("Force along the plate's normal", "force (N)", 2, 1.0));
  plot.panels.back().lines.push_back({"wanted", moving.table.column(1), true});
  plot.panels.push_back(compared("Distance from the circle on the plate", "distance (mm)", 3, 1e3));
  plot.panels.push_back({"Plate", "angle (rad)", {{"", moving.table.column(5), false}}, 0.1});
  plot.panels.push_back(
      {"Wanted height of the flange", "height (m)", {{"", moving.table.column(6), false}}, 0.01});
  return plot;
}

bool press_claim_holds(const PressRun& moving, const PressRun& fixed) {
  const PressFigures& ours = moving.figures;
  const bool kept = !moving.fault && !fixed.fault && !ours.lost_contact && ours.force_error < 1.0 &&
                    ours.slide_error < 1e-4 && ours.tilt_error < 1e-3 && ours.torque < 1.0;
  const bool hard = ours.tilt > 0.26 && ours.heave > 0.03;
  return kept && hard && fixed.figures.force_error > 10.0 * ours.force_error &&
         fixed.figures.slide_error > 10.0 * ours.slide_error;
}

}  // namespace treeline::experiments
