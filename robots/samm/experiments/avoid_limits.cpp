#include "avoid_limits.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "circles.hpp"
#include "core/ldlt.hpp"
#include "core/posture_laws.hpp"
#include "samm_joints.hpp"
#include "servo/pose_reference.hpp"
#include "servo/run_for.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {
namespace {

using State = servo::StateOf<Samm>;
using Limits = servo::SafetyLimits<9, 9>;

constexpr double kPeriod = 1e-3;    ///< s
constexpr double kDuration = 7.0;   ///< s
constexpr double kTurn = 1.8;       ///< of the tool, rad
constexpr double kTurnTime = 5.0;   ///< s
constexpr double kMargin = 0.35;    ///< distance from a limit at which avoidance begins, rad
constexpr double kStrength = 60.0;  ///< torque at the limit, N m
constexpr core::Gains<double> kTask{1600.0, 80.0};
/// Springs towards the start, N/m and N m/rad. They are weak for the base, so that it can go round.
constexpr double kSprings[9] = {20, 20, 10, 5, 10, 10, 1, 1, 1};
constexpr std::size_t kColumns = 22;

std::vector<std::string> column_names() {
  std::vector<std::string> names{"time", "position_error", "rotation_error", "margin"};
  for (const std::string quantity : {"q_", "tau_"}) {
    for (const char* joint : samm::kCoordinateJoints) {
      names.push_back(quantity + joint);
    }
  }
  return names;
}

/// Pose of the tool, and its error and velocity relative to the desired motion.
struct Tracking {
  servo::PoseMotion wanted;
  double error[6] = {};
  double velocity[6] = {};
};

Tracking track(const servo::PoseReference& reference, double time, const State& state) {
  Tracking tracking;
  tracking.wanted = reference.at(time);
  double position[3];
  double rotation[9];
  double J[54];
  samm::forward_kinematics(state.q, position, rotation);
  samm::jacobian(state.q, J);
  core::pose_error(position, rotation, tracking.wanted.position, tracking.wanted.rotation,
                   tracking.error);
  for (int i = 0; i < 54; ++i) {
    tracking.velocity[i / 9] += J[i] * state.qd[i % 9];
  }
  return tracking;
}

/// The rotation about the vertical, in place.
servo::PoseReference turn_in_place(const double (&q)[9]) {
  double position[3];
  double rotation[9];
  double to[9] = {};
  double by[9];
  samm::forward_kinematics(q, position, rotation);
  const double turn[3] = {0.0, 0.0, kTurn};
  core::rotation_from_vector(turn, by);
  for (int i = 0; i < 9; ++i) {
    for (int k = 0; k < 3; ++k) {
      to[i] += by[i / 3 * 3 + k] * rotation[3 * k + i % 3];
    }
  }
  servo::PoseReference reference;
  reference.move(0.5, position, rotation, position, to, kTurnTime);
  return reference;
}

/// Least distance of all joints from their nearer limit (rad or m), and the index of that joint.
double least_margin(const servo::SafetyLimits<9, 9>& limits, const double (&q)[9], int& joint) {
  double least = 1e9;
  for (std::size_t i = 3; i < 9; ++i) {
    const double margin = std::min(q[i] - limits.lower[i], limits.upper[i] - q[i]);
    if (margin < least) {
      least = margin;
      joint = static_cast<int>(i);
    }
  }
  return least;
}

void record(double time, const Tracking& tracking, const servo::SafetyLimits<9, 9>& limits,
            const State& state, const double (&tau)[9], AvoidRun& run) {
  const double* e = tracking.error;
  AvoidFigures& figures = run.figures;
  int joint = 0;
  double row[kColumns] = {time, std::hypot(e[0], e[1], e[2]), std::hypot(e[3], e[4], e[5]),
                          least_margin(limits, state.q, joint)};
  for (std::size_t i = 0; i < 9; ++i) {
    row[4 + i] = state.q[i];
    row[13 + i] = tau[i];
    figures.torque = std::max(figures.torque, std::fabs(tau[i]) / limits.torque[i]);
  }
  run.table.append(row);
  figures.joint = row[3] < figures.margin ? joint : figures.joint;
  figures.margin = std::min(figures.margin, row[3]);
  figures.position_error = std::max(figures.position_error, row[1]);
  figures.rotation_error = std::max(figures.rotation_error, row[2]);
  figures.base_travel = std::max(figures.base_travel, std::hypot(state.q[0], state.q[1]));
}

report::PlotPanel joints(const std::string& title, const AvoidRun& run) {
  report::PlotPanel panel{title, "angle (rad)", {}, 0.0};
  for (std::size_t i = 2; i < 9; ++i) {
    panel.lines.push_back({i == 2 ? std::string("base yaw") : fmt::format("joint {}", i - 2),
                           run.table.column(4 + i), false});
  }
  return panel;
}

/// qdd_0 = M^-1 tau_0. tau_0 has springs and dampers about the start and, if `avoiding`, torques
/// that push away from limits. Torques are used because an acceleration of the wrist's small mass
/// would not move the base.
void advise(bool avoiding, const servo::SafetyLimits<9, 9>& limits, const double (&start)[9],
            const State& state, double (&qdd_0)[9]) {
  double lower[9];
  double upper[9];
  std::copy(limits.lower.begin(), limits.lower.end(), lower);
  std::copy(limits.upper.begin(), limits.upper.end(), upper);
  double M[81];
  samm::mass_matrix(state.q, M);
  for (int i = 0; i < 9; ++i) {
    const double damper = 2.0 * std::sqrt(kSprings[i] * M[10 * i]);
    qdd_0[i] = kSprings[i] * (start[i] - state.q[i]) - damper * state.qd[i];
  }
  if (avoiding) {
    core::add_limit_avoidance(lower, upper, kMargin, kStrength, 20.0, state.q, state.qd, qdd_0);
  }
  core::ldlt_factor<9>(M);
  core::ldlt_solve(M, qdd_0);
}

}  // namespace

AvoidRun run_avoid_limits(bool avoiding) {
  const CirclePlan plan;
  const auto limits = samm_limits();
  State start;
  std::copy(std::begin(plan.start), std::end(plan.start), std::begin(start.q));
  const servo::PoseReference reference = turn_in_place(start.q);
  servo::SimulatedRobot<Samm> robot(start);
  const int cycles = static_cast<int>(std::lround(kDuration / kPeriod));
  AvoidRun run{report::Table(column_names(), static_cast<std::size_t>(cycles) + 1), {}};
  const auto law = [&](double time, const State& state, double(&tau)[9]) {
    const Tracking tracking = track(reference, time, state);
    double xdd_cmd[6];
    double qdd_0[9];
    core::tracking_law(kTask, tracking.error, tracking.velocity, tracking.wanted.velocity,
                       tracking.wanted.acceleration, xdd_cmd);
    advise(avoiding, limits, plan.start, state, qdd_0);
    samm::control_torque(state.q, state.qd, qdd_0, xdd_cmd, tau);
    record(time, tracking, limits, state, tau, run);
    return true;
  };
  // The loop keeps the limits where they are avoided; else it shall not stop beyond them.
  const servo::RunEnd end =
      servo::run_law<Samm>(kDuration, 1.0 / kPeriod, avoiding ? limits : Limits{}, robot, law);
  run.figures.fault = static_cast<bool>(end.fault);
  return run;
}

std::string avoid_summary(const AvoidRun& avoiding, const AvoidRun& without) {
  std::string text = fmt::format(
      "SAMM's tool turns by {} rad in place\n{:<20}{:>12}{:>8}{:>14}"
      "{:>14}{:>12}{:>14}\n",
      kTurn, "limits", "margin rad", "joint", "tool off m", "off rad", "base went m",
      "torque/limit");
  for (const AvoidRun* run : {&without, &avoiding}) {
    const AvoidFigures& f = run->figures;
    text += fmt::format("{:<20}{:>12.3f}{:>8}{:>14.2e}{:>14.2e}{:>12.3f}{:>14.3g}\n",
                        run == &avoiding ? "avoided" : "not heeded", f.margin, f.joint - 2,
                        f.position_error, f.rotation_error, f.base_travel, f.torque);
  }
  return text;
}

report::Plot avoid_figure(const AvoidRun& avoiding, const AvoidRun& without) {
  report::Plot plot;
  plot.title = "SAMM turns its tool in place, joint limits avoided in the null space";
  plot.x_label = "time (s)";
  plot.x = avoiding.table.column(0);
  plot.panels.push_back({"Distance of the nearest joint from its limit",
                         "angle (rad)",
                         {{"avoided", avoiding.table.column(3), false},
                          {"not heeded", without.table.column(3), false},
                          {"limit", std::vector<double>(plot.x.size(), 0.0), true}},
                         0.0});
  plot.panels.push_back(joints("Joints, limits avoided", avoiding));
  plot.panels.push_back(joints("Joints, limits not heeded", without));
  std::vector<std::vector<double>> errors{avoiding.table.column(1), without.table.column(1)};
  for (auto& values : errors) {
    for (double& value : values) {
      value *= 1e6;
    }
  }
  plot.panels.push_back({"Tool's position error",
                         "distance (\u00b5m)",
                         {{"avoided", errors[0], false}, {"not heeded", errors[1], false}},
                         0.0});
  return plot;
}

bool avoid_claim_holds(const AvoidRun& avoiding, const AvoidRun& without) {
  bool tracked = true;
  for (const AvoidRun* run : {&avoiding, &without}) {
    tracked = tracked && !run->figures.fault && run->figures.position_error < 1e-5 &&
              run->figures.rotation_error < 1e-4;
  }
  return tracked && without.figures.margin < 0.0 && avoiding.figures.margin > 0.02 &&
         avoiding.figures.torque < 1.0;
}

}  // namespace treeline::experiments
