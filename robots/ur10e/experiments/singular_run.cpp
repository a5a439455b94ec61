#include "singular_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/command_laws.hpp"
#include "core/spline.hpp"
#include "servo/run_for.hpp"
#include "servo/simulated_robot.hpp"
#include "ur10e_joints.hpp"

namespace treeline::ur10e_experiments {
namespace {

struct Arm {
  static constexpr int kCoordinates = ur10e::kCoordinates;
  static constexpr int kVelocities = ur10e::kVelocities;
  static constexpr auto& inverse_dynamics = ur10e::inverse_dynamics;
  static constexpr auto& forward_dynamics = ur10e::forward_dynamics;
};
using State = servo::StateOf<Arm>;

constexpr double kPeriod = 1e-3;  ///< s
constexpr core::Gains<double> kTask{100.0, 20.0};
constexpr double kGoalSpeed = 0.3, kGoalTurning = 0.7;              ///< largest m/s and rad/s
constexpr double kEffort[6] = {330, 330, 150, 56, 56, 56};          ///< N m, from the URDF
constexpr double kSpeed[6] = {2.09, 2.09, 3.14, 3.14, 3.14, 3.14};  ///< rad/s
constexpr double kUpperArm = 0.6127, kForearm = 0.57155;            ///< m
constexpr std::size_t kPositions = 4, kSpeeds = 10, kTorques = 16;  ///< columns

/// Path from the pose of `start` along `travel` and back, at rest at both ends; if `stiffness` is
/// not zero, to the given pose instead.
struct Path {
  double start[6] = {};
  double position[3] = {};
  double rotation[9] = {};
  double travel[3] = {};
  double seconds = 2.0;  ///< s in each direction
  double wait = 1.0;     ///< s at the end
  double stiffness = 0;  ///< 1/s^2
};

Path reach_path() {
  Path path{{0.0, -0.9, 1.1, -1.4, -1.3, 0.0}, {}, {}, {}, 2.0, 1.0};
  // Joint 1 is zero, so shoulder, elbow and wrist lie in a plane y = const.
  const double fore = path.start[1] + path.start[2];
  const double x = -kUpperArm * std::cos(path.start[1]) - kForearm * std::cos(fore);
  const double z = -kUpperArm * std::sin(path.start[1]) - kForearm * std::sin(fore);
  const double distance = std::hypot(x, z);
  const double far = kUpperArm + kForearm - distance + 0.02;
  path.travel[0] = far * x / distance;
  path.travel[2] = far * z / distance;
  return path;
}

Path wrist_path() {
  // Axis 5 leans 0.034 rad from the vertical and joint 5 is -0.3, so axis 6 is 0.01 off the
  // horizontal.
  return {{-0.3, -1.2, 1.6, -0.4 + 0.034, -0.3, 0.0}, {}, {}, {0.0, -0.45, 0.0}, 2.0, 1.0};
}

/// The tool points forward and down by an eighth of a turn. The tutorial's arm reaches out along x,
/// this one along -x in its frame, so everything is rotated by pi about z.
Path goal_path(double x, double y, double z, double stiffness) {
  const double s = std::sqrt(0.5);
  return {{0.0, -1.712, 1.712, 0.0, 0.0, 0.0},
          {-x, -y, z},
          {-s, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, -s},
          {},
          2.5,
          0.0,
          stiffness};
}

Path make_path(Line line) {
  switch (line) {
    case Line::goal_1:
      return goal_path(0.6, 0.15, 0.3, 360.0);
    case Line::goal_2:
      return goal_path(0.6, -0.3, 0.3, 420.0);
    case Line::goal_3:
      return goal_path(0.8, 0.0, 0.5, 320.0);
    case Line::reach:
    case Line::wrist:
      break;
  }
  Path path = line == Line::reach ? reach_path() : wrist_path();
  ur10e::forward_kinematics(path.start, path.position, path.rotation);
  return path;
}

core::Motion<1, double> along(const Path& path, double t) {
  const double zero[1] = {0.0};
  const double one[1] = {1.0};
  const bool back = t > path.seconds;
  return back ? core::rest_to_rest(one, zero, path.seconds).at(t - path.seconds)
              : core::rest_to_rest(zero, one, path.seconds).at(t);
}

/// PD control about the path. Also returns the present error.
void command(const Path& path, double t, const State& state, double (&error)[6],
             double (&xdd_cmd)[6]) {
  const auto s = along(path, t);
  double wanted[3];
  double velocity_wanted[6] = {};
  double acceleration_wanted[6] = {};
  for (int i = 0; i < 3; ++i) {
    wanted[i] = path.position[i] + s.position[0] * path.travel[i];
    velocity_wanted[i] = s.velocity[0] * path.travel[i];
    acceleration_wanted[i] = s.acceleration[0] * path.travel[i];
  }
  double position[3];
  double rotation[9];
  double J[36];
  double velocity[6] = {};
  ur10e::forward_kinematics(state.q, position, rotation);
  ur10e::jacobian(state.q, J);
  for (int i = 0; i < 36; ++i) {
    velocity[i / 6] += J[i] * state.qd[i % 6];
  }
  core::pose_error(position, rotation, wanted, path.rotation, error);
  if (path.stiffness > 0.0) {
    core::saturated_goal_law({path.stiffness, 2.0 * std::sqrt(path.stiffness)}, error, velocity,
                             kGoalSpeed, kGoalTurning, xdd_cmd);
    return;
  }
  core::tracking_law(kTask, error, velocity, velocity_wanted, acceleration_wanted, xdd_cmd);
}

/// Appends the cycle to the table and updates the figures. Returns false if the run is lost.
bool record(double time, const State& state, const double (&error)[6], const double (&tau)[6],
            const double (&tau_before)[6], double ease, SingularRun& run) {
  Figures& figures = run.figures;
  const double position = std::hypot(error[0], error[1], error[2]);
  const double rotation = std::hypot(error[3], error[4], error[5]);
  double row[22] = {time, position, rotation, ease};
  for (std::size_t i = 0; i < 6; ++i) {
    row[kPositions + i] = state.q[i];
    row[kSpeeds + i] = state.qd[i];
    row[kTorques + i] = tau[i];
    figures.torque = std::max(figures.torque, std::fabs(tau[i]) / kEffort[i]);
    figures.speed = std::max(figures.speed, std::fabs(state.qd[i]) / kSpeed[i]);
    const double step = time > 0.0 ? std::fabs(tau[i] - tau_before[i]) / kEffort[i] : 0.0;
    figures.torque_step = std::max(figures.torque_step, step);
    figures.lost = figures.lost || !(figures.torque < 1e3) || !std::isfinite(tau[i]);
  }
  run.table.append(row);
  figures.position_error = std::max(figures.position_error, position);
  figures.rotation_error = std::max(figures.rotation_error, rotation);
  figures.final_error = position + rotation;
  figures.ease = std::min(figures.ease, ease);
  return !figures.lost;
}

/// Whether the path is a line. On the way to a goal the error is the remaining distance.
bool has_line(Line line) {
  return line == Line::reach || line == Line::wrist;
}

std::vector<std::string> column_names() {
  std::vector<std::string> names{"time", "position_error", "rotation_error", "ease"};
  for (const char* quantity : {"q", "qd", "tau"}) {
    for (const char* joint : ur10e::kCoordinateJoints) {
      names.push_back(fmt::format("{}_{}", quantity, joint));
    }
  }
  return names;
}

/// A panel with one curve for each run. Lost runs end early; values far off the scale are cut.
report::PlotPanel compared(const std::string& title, const std::string& label,
                           const std::vector<SingularRun>& runs, std::size_t column, double most) {
  const std::size_t rows = runs.back().table.rows();
  report::PlotPanel panel{title, label, {}, 0.0};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<double> values = runs[i].table.column(column);
    values.resize(rows, std::nan(""));
    for (double& value : values) value = std::fabs(value) <= most ? value : std::nan("");
    panel.lines.push_back({name_of(kLaws[i]), std::move(values), false});
  }
  return panel;
}

/// The largest of six columns, each divided by its limit, by row.
std::vector<double> largest_share(const SingularRun& run, std::size_t first,
                                  const double (&limits)[6], std::size_t rows, double most) {
  std::vector<double> largest(run.table.rows(), 0.0);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::vector<double> column = run.table.column(first + i);
    for (std::size_t k = 0; k < largest.size(); ++k) {
      largest[k] = std::max(largest[k], std::fabs(column[k]) / limits[i]);
    }
  }
  for (double& value : largest) value = value <= most ? value : std::nan("");
  largest.resize(rows, std::nan(""));
  return largest;
}

report::PlotPanel shares(const std::string& title, const std::vector<SingularRun>& runs,
                         std::size_t first, const double (&limits)[6]) {
  constexpr double kMost = 3.0;
  const std::size_t rows = runs.back().table.rows();
  report::PlotPanel panel{title, "largest of six (cut at 3)", {}, 0.0};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    panel.lines.push_back(
        {name_of(kLaws[i]), largest_share(runs[i], first, limits, rows, kMost), false});
  }
  return panel;
}

}  // namespace

const char* title_of(Line line) {
  switch (line) {
    case Line::reach:
      return "2 cm beyond reach";
    case Line::wrist:
      return "past the wrist's lock";
    case Line::goal_1:
      return "from the lock to goal 1";
    case Line::goal_2:
      return "from the lock to goal 2";
    case Line::goal_3:
      return "from the lock to goal 3";
  }
  return "";
}

std::string file_name_of(Line line) {
  constexpr std::array kNames{"reach", "wrist", "goal_1", "goal_2", "goal_3"};
  return kNames[static_cast<std::size_t>(line)];
}

SingularRun run_line(Line line, Law law) {
  const Path path = make_path(line);
  const int cycles = static_cast<int>(std::lround((2.0 * path.seconds + path.wait) / kPeriod));
  SingularRun run{report::Table(column_names(), static_cast<std::size_t>(cycles) + 1), {}};
  State start;
  std::copy(std::begin(path.start), std::end(path.start), std::begin(start.q));
  servo::SimulatedRobot<Arm> robot(start);
  double before[6] = {};
  const auto step = [&](double time, const State& state, double(&tau)[6]) {
    double error[6];
    double xdd_cmd[6];
    command(path, time, state, error, xdd_cmd);
    const double ease = control(law, state.q, state.qd, xdd_cmd, tau);
    const bool goes_on = record(time, state, error, tau, before, ease, run);
    std::copy(std::begin(tau), std::end(tau), std::begin(before));
    return goes_on;
  };
  // Without limits: what laws without damping exceed is what the figures show.
  servo::run_law<Arm>(2.0 * path.seconds + path.wait, 1.0 / kPeriod, {}, robot, step);
  return run;
}

std::string summary(Line line, const std::vector<SingularRun>& runs) {
  std::string text = fmt::format("{:<24}{:>12}{:>12}{:>14}{:>12}{:>12}{:>12}{:>12}\n",
                                 title_of(line), "|tau|/limit", "|qd|/limit", "step of tau",
                                 "position m", "rotation", "at the end", "least ease");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Figures& f = runs[i].figures;
    text += fmt::format(
        "{:<24}{:>12.3g}{:>12.3g}{:>14.3g}{:>12.2e}{:>12.2e}{:>12.2e}{:>12.1e}{}\n",
        name_of(kLaws[i]), f.torque, f.speed, f.torque_step, f.position_error, f.rotation_error,
        f.final_error, f.ease,
        f.lost ? fmt::format("  lost at {:.3f} s", runs[i].table.column(0).back()) : "");
  }
  return text;
}

std::string rows_of(Line line, const std::vector<SingularRun>& runs) {
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Figures& f = runs[i].figures;
    text += fmt::format("| {} | {} |", i == 0 ? title_of(line) : "", name_of(kLaws[i]));
    if (f.lost) {
      text += " over 1000, lost | | | |\n";
      continue;
    }
    text += fmt::format(" {:.2f} | {:.2f} |", f.torque, f.speed);
    text += has_line(line) ? fmt::format(" {:.4f} | {:.3f} |\n", f.position_error, f.rotation_error)
                           : " | |\n";
  }
  return text;
}

report::Plot figure(Line line, const std::vector<SingularRun>& runs) {
  report::Plot plot;
  plot.title = fmt::format("UR10e: {}", title_of(line));
  plot.x_label = "time (s)";
  plot.x = runs.back().table.column(0);
  plot.panels.push_back(shares("Joint torque over its limit", runs, kTorques, kEffort));
  plot.panels.push_back(shares("Joint speed over its limit", runs, kSpeeds, kSpeed));
  const double most_m = has_line(line) ? 0.2 : 1.0, most_rad = has_line(line) ? 0.5 : 3.0;
  plot.panels.push_back(
      compared("Position error", fmt::format("m (cut at {})", most_m), runs, 1, most_m));
  plot.panels.push_back(
      compared("Orientation error", fmt::format("rad (cut at {})", most_rad), runs, 2, most_rad));
  plot.panels.push_back(compared("Least ease", "1: begins to yield (cut at 4)", runs, 3, 4.0));
  return plot;
}

bool claim_holds(Line line, const std::vector<SingularRun>& runs) {
  const Figures& exact = runs[0].figures;
  const Figures& squares = runs[1].figures;
  const Figures& damped = runs[2].figures;
  const bool bounded = !damped.lost && damped.torque < 1.0 && damped.speed < 1.0;
  const bool smooth = damped.torque_step < 0.05 && damped.final_error < 1e-3;
  // Beside the lock the exact law passes, at several times the arm's limits.
  const bool needed = line == Line::wrist ? exact.torque > 2.0 && exact.speed > 8.0 : exact.lost;
  const double nearer = has_line(line) ? squares.position_error / damped.position_error : 1e300;
  return bounded && smooth && needed && nearer > 2.0;
}

}  // namespace treeline::ur10e_experiments
