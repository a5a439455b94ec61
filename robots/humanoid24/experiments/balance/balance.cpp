#include "balance.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/command_laws.hpp"
#include "core/ldlt.hpp"
#include "core/posture_laws.hpp"
#include "humanoid24_balance.hpp"
#include "joint_panel.hpp"
#include "servo/pose_reference.hpp"
#include "servo/run_for.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {
namespace {

namespace robot = humanoid24_balance;
constexpr int kJoints = robot::kVelocities;
static_assert(kJoints == 24 && robot::kCoordinates == 24 && robot::kTaskRows == 6);

struct Humanoid {
  static constexpr int kCoordinates = robot::kCoordinates;
  static constexpr int kVelocities = robot::kVelocities;
  static constexpr auto& inverse_dynamics = robot::inverse_dynamics;
  static constexpr auto& forward_dynamics = robot::forward_dynamics;
};
using State = servo::StateOf<Humanoid>;

constexpr double kPeriod = 1e-3;   ///< s
constexpr double kDuration = 6.0;  ///< s
constexpr double kLead = 0.25;
constexpr double kReachTime = 3.0;
constexpr double kReach[3] = {0.32, 0.0, -0.2};  ///< displacement of the hand, m
// Edges of the feet (README.md): x of both feet, y of their outer sides.
constexpr double kHeel = -0.065, kToe = 0.193, kSide = 0.135;
constexpr double kInset = 0.09;  ///< distance from the edges at which the law begins to act, m
constexpr core::Gains<double> kBalance{200.0, 28.0};
constexpr std::size_t kFixed = 8;

/// Pose and motion of the hand and the centre of mass.
struct Seen {
  double hand_error[6] = {};
  double hand_velocity[6] = {};
  servo::PoseMotion wanted;
  double com[3] = {};
  double J_com[3 * kJoints] = {};
};

Seen see(const servo::PoseReference& reference, double time, const State& state) {
  Seen seen;
  double position[3];
  double rotation[9];
  double J[6 * kJoints];
  robot::forward_kinematics(state.q, position, rotation);
  robot::jacobian(state.q, J);
  robot::center_of_mass(state.q, seen.com);
  robot::center_of_mass_jacobian(state.q, seen.J_com);
  seen.wanted = reference.at(time);
  core::pose_error(position, rotation, seen.wanted.position, seen.wanted.rotation, seen.hand_error);
  for (int i = 0; i < 6 * kJoints; ++i) {
    seen.hand_velocity[i / kJoints] += J[i] * state.qd[i % kJoints];
  }
  return seen;
}

/// qdd_0 of the posture: the plan's posture by springs and dampers, M^-1 (K (start - q) - D qd),
/// and if `balancing` the centre of mass over the inset support. K is the posture stiffness times
/// M_ii. It has a potential, so the body comes to rest.
void advise(const Plan& plan, bool balancing, const Seen& seen, const State& state,
            double (&qdd_0)[kJoints]) {
  double M[kJoints * kJoints];
  robot::mass_matrix(state.q, M);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double kp = plan.posture_stiffness[i];
    const double inertia = M[(kJoints + 1) * i];
    qdd_0[i] = inertia * (kp * (plan.start[i] - state.q[i]) - 2.0 * std::sqrt(kp) * state.qd[i]);
  }
  core::ldlt_factor<kJoints>(M);
  core::ldlt_solve(M, qdd_0);
  if (!balancing) {
    return;
  }
  constexpr double kCorners[8] = {kHeel + kInset, -kSide + kInset, kToe - kInset,  -kSide + kInset,
                                  kToe - kInset,  kSide - kInset,  kHeel + kInset, kSide - kInset};
  const double com[2] = {seen.com[0], seen.com[1]};
  // Within the support the law only damps. It is always on, so that it begins without a jerk.
  double goal[2];
  core::nearest_in_polygon(kCorners, com, goal);
  double horizontal[2 * kJoints];
  std::copy_n(seen.J_com, 2 * kJoints, horizontal);
  core::add_balance(kBalance, goal, com, horizontal, 0.01, state.qd, qdd_0);
}

double edge_margin(const double (&com)[3]) {
  return std::min({com[0] - kHeel, kToe - com[0], com[1] + kSide, kSide - com[1]});
}

void record(double time, const Seen& seen, const State& state, const double (&tau)[kJoints],
            const JointLimits& limits, BalanceRun& run) {
  const double* e = seen.hand_error;
  double row[kFixed + 2 * kJoints] = {time,
                                      std::hypot(e[0], e[1], e[2]),
                                      std::hypot(e[3], e[4], e[5]),
                                      seen.com[0],
                                      seen.com[1],
                                      edge_margin(seen.com),
                                      seen.wanted.position[0],
                                      seen.wanted.position[2]};
  BalanceFigures& figures = run.figures;
  for (std::size_t i = 0; i < kJoints; ++i) {
    row[kFixed + i] = state.q[i];
    row[kFixed + kJoints + i] = tau[i];
    figures.torque = std::max(figures.torque, std::fabs(tau[i]) / limits.effort[i]);
    figures.limit_margin = std::min(
        {figures.limit_margin, state.q[i] - limits.lower[i], limits.upper[i] - state.q[i]});
  }
  run.table.append(row);
  figures.margin = std::min(figures.margin, row[5]);
  figures.position_error = std::max(figures.position_error, row[1]);
  figures.rotation_error = std::max(figures.rotation_error, row[2]);
}

std::vector<std::string> column_names(const Plan& plan) {
  std::vector<std::string> names{"time",  "position_error", "rotation_error", "com_x",
                                 "com_y", "margin",         "hand_x_wanted",  "hand_z_wanted"};
  for (const char* quantity : {"q_", "tau_"}) {
    for (const std::string& joint : plan.joints) {
      names.push_back(quantity + joint);
    }
  }
  return names;
}

servo::PoseReference reach_from(const double (&q)[kJoints]) {
  double position[3];
  double rotation[9];
  robot::forward_kinematics(q, position, rotation);
  const double to[3] = {position[0] + kReach[0], position[1] + kReach[1], position[2] + kReach[2]};
  servo::PoseReference reference;
  reference.move(kLead, position, rotation, to, rotation, kReachTime);
  return reference;
}

}  // namespace

BalanceRun run_balance(const Plan& plan, const JointLimits& limits, bool balancing) {
  State start;
  std::copy(plan.start.begin(), plan.start.end(), std::begin(start.q));
  const servo::PoseReference reference = reach_from(start.q);
  servo::SimulatedRobot<Humanoid> simulated(start);
  const int cycles = static_cast<int>(std::lround(kDuration / kPeriod));
  BalanceRun run{report::Table(column_names(plan), static_cast<std::size_t>(cycles) + 1), {}};
  const auto law = [&](double time, const State& state, double(&tau)[kJoints]) {
    const Seen seen = see(reference, time, state);
    double xdd_cmd[6];
    double qdd_0[kJoints];
    core::tracking_law<6, double>({plan.stiffness, plan.damping}, seen.hand_error,
                                  seen.hand_velocity, seen.wanted.velocity,
                                  seen.wanted.acceleration, xdd_cmd);
    advise(plan, balancing, seen, state, qdd_0);
    robot::control_torque(state.q, state.qd, qdd_0, xdd_cmd, tau);
    record(time, seen, state, tau, limits, run);
    return true;
  };
  // Without balance the body leaves its limits of motion, which is what the figures show.
  servo::run_law<Humanoid>(kDuration, 1.0 / kPeriod, {}, simulated, law);
  return run;
}

std::string balance_summary(const BalanceRun& balancing, const BalanceRun& without) {
  std::string text = fmt::format(
      "the humanoid's left hand reaches {:.2f} m forward and {:.2f} m down\n"
      "{:<16}{:>20}{:>14}{:>14}{:>14}{:>18}\n",
      kReach[0], -kReach[2], "centre of mass", "within feet by m", "hand off m", "off rad",
      "torque/limit", "nearest limit rad");
  for (const BalanceRun* run : {&without, &balancing}) {
    const BalanceFigures& f = run->figures;
    text += fmt::format("{:<16}{:>20.4f}{:>14.2e}{:>14.2e}{:>14.3g}{:>18.3f}\n",
                        run == &balancing ? "kept over feet" : "not heeded", f.margin,
                        f.position_error, f.rotation_error, f.torque, f.limit_margin);
  }
  return text;
}

report::Plot balance_figure(const BalanceRun& balancing, const BalanceRun& without,
                            const Plan& plan) {
  report::Plot plot;
  plot.title = "The left hand reaches, the centre of mass stays over the feet";
  plot.x_label = "time (s)";
  plot.x = balancing.table.column(0);
  plot.panels.push_back({"Centre of mass, forward",
                         "x (m)",
                         {{"balanced", balancing.table.column(3), false},
                          {"without", without.table.column(3), false},
                          {"heel, toe", std::vector<double>(plot.x.size(), kToe), true},
                          {"", std::vector<double>(plot.x.size(), kHeel), true}},
                         0.0});
  plot.panels.push_back(
      {"Hand, wanted",
       "position (m)",
       {{"x", balancing.table.column(6), false}, {"z", balancing.table.column(7), false}},
       0.0});
  std::vector<double> errors[2] = {balancing.table.column(1), without.table.column(1)};
  for (auto& values : errors) {
    for (double& value : values) {
      value *= 1e6;
    }
  }
  plot.panels.push_back({"Hand's position error",
                         "distance (\u00b5m)",
                         {{"balanced", errors[0], false}, {"without", errors[1], false}},
                         0.0});
  plot.panels.push_back(joint_panel(balancing.table, plan, "Joints, balanced, from the start",
                                    "angle (rad)", kFixed, true));
  plot.panels.push_back(joint_panel(without.table, plan, "Joints, without, from the start",
                                    "angle (rad)", kFixed, true));
  return plot;
}

bool balance_claim_holds(const BalanceRun& balancing, const BalanceRun& without) {
  bool tracked = true;
  for (const BalanceRun* run : {&balancing, &without}) {
    tracked = tracked && run->figures.position_error < 1e-5 && run->figures.rotation_error < 1e-4;
  }
  const BalanceFigures& ours = balancing.figures;
  return tracked && without.figures.margin < -0.01 && ours.margin > 0.02 && ours.torque < 1.0 &&
         ours.limit_margin > 0.0;
}

}  // namespace treeline::experiments
