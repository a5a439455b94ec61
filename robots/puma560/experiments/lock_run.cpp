#include "lock_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/command_laws.hpp"
#include "servo/run_for.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {
namespace {

struct Puma {
  static constexpr int kCoordinates = puma560::kCoordinates;
  static constexpr int kVelocities = puma560::kVelocities;
  static constexpr auto& inverse_dynamics = puma560::inverse_dynamics;
  static constexpr auto& forward_dynamics = puma560::forward_dynamics;
};
using State = servo::StateOf<Puma>;

constexpr double kPeriod = 1e-3;    ///< s
constexpr double kLookAhead = 0.2;  ///< s of desired velocity that count as desired motion
constexpr core::Gains<double> kTask{100.0, 20.0};
constexpr double kEffort[6] = {97.6, 186.4, 89.4, 24.2, 20.1, 21.3};      ///< N m, from the URDF
constexpr double kLower[6] = {-2.79, -3.93, -0.79, -1.92, -1.75, -4.64};  ///< rad, from the URDF
constexpr double kUpper[6] = {2.79, 0.79, 3.93, 2.97, 1.75, 4.64};
constexpr std::size_t kErrorColumns = 1;
constexpr std::size_t kPositions = 4;
constexpr std::size_t kSpeeds = 10;
constexpr std::size_t kTorques = 16;
constexpr std::size_t kShare = 22;
constexpr std::size_t kColumns = 24;

std::vector<std::string> column_names() {
  std::vector<std::string> names{"time", "position_error", "rotation_error", "sigma"};
  for (const char* quantity : {"q", "qd", "tau"}) {
    for (int i = 1; i <= 6; ++i) {
      names.push_back(fmt::format("{}_joint{}", quantity, i));
    }
  }
  names.emplace_back("share");
  names.emplace_back("type");
  return names;
}

/// PD control about the desired motion. Also returns the present error.
ToolCommand command_for(const ToolMotion& wanted, const State& state, double (&error)[6]) {
  double position[3];
  double rotation[9];
  double J[36];
  double velocity[6] = {};
  puma560::forward_kinematics(state.q, position, rotation);
  puma560::jacobian(state.q, J);
  for (int i = 0; i < 36; ++i) {
    velocity[i / 6] += J[i] * state.qd[i % 6];
  }
  core::pose_error(position, rotation, wanted.position, wanted.rotation, error);
  ToolCommand command;
  core::tracking_law(kTask, error, velocity, wanted.velocity, wanted.acceleration,
                     command.acceleration);
  for (int i = 0; i < 6; ++i) {
    command.displacement[i] = error[i] + kLookAhead * wanted.velocity[i];
  }
  return command;
}

/// Number of a type in Chang's classification; 0 if it has none.
int type_number(core::SingularityType type) {
  return type == core::SingularityType::moves_along
             ? 1
             : (type == core::SingularityType::turns ? 2 : 0);
}

/// Updates the phases of the run with this cycle.
void follow_phases(const WeakestDirection& weakest, LockRun& run) {
  LockFigures& figures = run.figures;
  const double share = weakest.all.shares[5];
  const bool first = run.table.rows() == 0;
  run.began_regular = first ? share == 1.0 : run.began_regular;
  if (share == 0.0) {
    figures.type =
        !run.was_in || figures.type == weakest.type ? weakest.type : core::SingularityType::none;
    run.was_in = true;
  }
  figures.three_phases = run.began_regular && run.was_in && share == 1.0;
}

/// Appends the cycle to the table and updates the figures. Returns false if the run is lost.
bool record(double time, const State& state, const double (&error)[6], const double (&tau)[6],
            LockRun& run) {
  LockFigures& figures = run.figures;
  const double position = std::hypot(error[0], error[1], error[2]);
  const double rotation = std::hypot(error[3], error[4], error[5]);
  const WeakestDirection weakest = look_at_direction(state.q, 5);
  follow_phases(weakest, run);
  double row[kColumns] = {time, position, rotation, weakest.all.values[5]};
  row[kShare] = weakest.all.shares[5];
  row[kShare + 1] = type_number(weakest.type);
  for (std::size_t i = 0; i < 6; ++i) {
    row[kPositions + i] = state.q[i];
    row[kSpeeds + i] = state.qd[i];
    row[kTorques + i] = tau[i];
    figures.speed = std::max(figures.speed, std::fabs(state.qd[i]));
    figures.torque = std::max(figures.torque, std::fabs(tau[i]) / kEffort[i]);
    figures.lost = figures.lost || !std::isfinite(tau[i]) || !(figures.torque < 1e3);
    figures.within_limits =
        figures.within_limits && state.q[i] > kLower[i] && state.q[i] < kUpper[i];
    figures.final_q[i] = state.q[i];
  }
  run.table.append(row);
  figures.position_error = std::max(figures.position_error, position);
  figures.rotation_error = std::max(figures.rotation_error, rotation);
  figures.final_position_error = position;
  figures.final_rotation_error = rotation;
  figures.least_value = std::min(figures.least_value, row[3]);
  return !figures.lost;
}

/// A panel with one curve for each run. Shorter runs end early.
report::PlotPanel compared(const std::string& title, const std::string& label,
                           const std::vector<LockRun>& runs, std::size_t column, std::size_t rows) {
  report::PlotPanel panel{title, label, {}, 0.0};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<double> values = runs[i].table.column(column);
    values.resize(rows, std::nan(""));
    if (runs[i].figures.lost) {
      continue;
    }
    panel.lines.push_back({name_of(kStrategies[i]), std::move(values), false});
  }
  return panel;
}

const char* title_of(Lock lock) {
  switch (lock) {
    case Lock::elbow:
      return "PUMA 560 through the elbow lock (Chang fig. A.2)";
    case Lock::head:
      return "PUMA 560 through the head lock (Chang appendix A)";
    case Lock::wrist:
      return "PUMA 560 into the wrist lock and out about the lost axis (Chang fig. A.3)";
  }
  return "";
}

report::PlotPanel joints(const std::string& title, const std::string& label, const LockRun& run,
                         std::size_t first) {
  report::PlotPanel panel{title, label, {}, 0.0};
  for (std::size_t i = 0; i < 6; ++i) {
    panel.lines.push_back({fmt::format("joint {}", i + 1), run.table.column(first + i), false});
  }
  return panel;
}

}  // namespace

LockRun run_lock(Lock lock, Strategy strategy, double branch) {
  const LockPath path = make_path(lock);
  const int cycles = static_cast<int>(std::lround(path.duration / kPeriod));
  LockRun run{report::Table(column_names(), static_cast<std::size_t>(cycles) + 1), {}, {}};
  std::copy(std::begin(path.start), std::end(path.start), std::begin(run.start));
  State start;
  std::copy(std::begin(path.start), std::end(path.start), std::begin(start.q));
  servo::SimulatedRobot<Puma> robot(start);
  const auto law = [&](double time, const State& state, double(&tau)[6]) {
    double error[6];
    const ToolCommand command = command_for(motion_at(path, time), state, error);
    control(strategy, state.q, state.qd, command, branch, tau);
    return record(time, state, error, tau, run);
  };
  // Without limits: what laws without a strategy exceed is what the figures show.
  servo::run_law<Puma>(path.duration, 1.0 / kPeriod, {}, robot, law);
  return run;
}

std::string lock_summary(Lock lock, const std::vector<LockRun>& runs) {
  std::string text = fmt::format(
      "{:<22}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n{:<22}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}"
      "{:>12}\n",
      name_of(lock), "torque", "speed", "position", "rotation", "left at end", "left at end",
      "least", "", "/ limit", "rad/s", "error m", "error rad", "m", "rad", "sigma");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const LockFigures& f = runs[i].figures;
    text += fmt::format(
        "{:<22}{:>12.3g}{:>12.3g}{:>12.2e}{:>12.2e}{:>12.2e}{:>12.2e}{:>12.1e}{}\n",
        name_of(kStrategies[i]), f.torque, f.speed, f.position_error, f.rotation_error,
        f.final_position_error, f.final_rotation_error, f.least_value,
        f.lost ? fmt::format("  lost at {:.3f} s", runs[i].table.column(0).back()) : "");
  }
  return text;
}

std::string lock_rows(Lock lock, const std::vector<LockRun>& runs) {
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const LockFigures& f = runs[i].figures;
    const std::string name = fmt::format("{}, {}", name_of(lock), name_of(kStrategies[i]));
    text += f.lost ? fmt::format("| {} | over 1000, lost | | | |\n", name)
                   : fmt::format("| {} | {:.2f} | {:.2f} | {:.3f} | {:.4f} |\n", name, f.torque,
                                 f.speed, f.position_error, f.rotation_error);
  }
  return text;
}

report::Plot lock_figure(Lock lock, const std::vector<LockRun>& runs) {
  const LockRun& controlled = runs.back();
  const std::size_t rows = controlled.table.rows();
  report::Plot plot;
  plot.title = title_of(lock);
  plot.x_label = "time (s)";
  plot.x = controlled.table.column(0);
  plot.panels.push_back(compared("Position error", "distance (m)", runs, kErrorColumns, rows));
  plot.panels.push_back(
      compared("Orientation error", "angle (rad)", runs, kErrorColumns + 1, rows));
  plot.panels.push_back(
      compared("Smallest singular value", "sigma (1)", runs, kErrorColumns + 2, rows));
  plot.panels.push_back({"Share of the weakest direction that is in the task, singularity control",
                         "share (1)",
                         {{"", controlled.table.column(kShare), false}},
                         1.0});
  plot.panels.push_back(
      joints("Joints, singularity control", "angle (rad)", controlled, kPositions));
  plot.panels.push_back(
      joints("Speeds, singularity control", "speed (rad/s)", controlled, kSpeeds));
  plot.panels.push_back(
      joints("Torques, singularity control", "torque (N m)", controlled, kTorques));
  return plot;
}

bool lock_claim_holds(Lock lock, const std::vector<LockRun>& runs) {
  const LockFigures& none = runs[0].figures;
  const LockFigures& damped = runs[1].figures;
  const LockFigures& ours = runs[2].figures;
  const bool bounded = !ours.lost && ours.within_limits && ours.torque < 1.0 && ours.speed < 3.6;
  const bool arrived = ours.final_position_error < 1e-5 && ours.final_rotation_error < 1e-4;
  const auto expected =
      lock == Lock::wrist ? core::SingularityType::turns : core::SingularityType::moves_along;
  const bool phases = ours.three_phases && ours.type == expected && ours.least_value < 1e-3;
  const double* from = runs[2].start;
  const bool passed = lock == Lock::elbow  ? ours.final_q[2] > from[2] + 1.1
                      : lock == Lock::head ? ours.final_q[0] < from[0] - 1.1
                                           : true;
  const bool farther = damped.position_error > 1.1 * ours.position_error &&
                       damped.rotation_error > 1.1 * ours.rotation_error;
  const bool came_back = std::fabs(damped.final_q[0] - from[0]) < 0.1;
  const bool worse = farther && (lock == Lock::head ? came_back : damped.speed > 1.1 * ours.speed);
  return bounded && arrived && phases && passed && none.lost && worse;
}

}  // namespace treeline::experiments
