#include "null_space.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/ldlt.hpp"
#include "core/posture_laws.hpp"
#include "planar3r.hpp"
#include "servo/integrate.hpp"

namespace treeline::experiments {
namespace {

constexpr int nv = planar3r::kVelocities;
constexpr int kRows = planar3r::kTaskRows;
static_assert(nv == 3 && kRows == 2);

constexpr double kStart[nv] = {0.9, -1.3, 1.4};
constexpr double kAttractor[nv] = {0.6, -0.4, 0.5};  ///< minimum of the potential, rad
constexpr double kStiffness = 8.0;                   ///< N m / rad
constexpr core::Gains<double> kTask{100.0, 20.0};
constexpr double kStep = 5e-4;  ///< s
constexpr int kSteps = 8000;

/// Replaces x by A^-1 x for a positive definite A.
template <int N, int NN>
void solve(const double (&A)[NN], double (&x)[N]) {
  double factors[NN];
  std::copy(std::begin(A), std::end(A), std::begin(factors));
  core::ldlt_factor<N>(factors);
  core::ldlt_solve(factors, x);
}

struct Torques {
  double task[nv] = {};     ///< J^T F, where F holds the tip
  double posture[nv] = {};  ///< N^T tau_0
};

/// N^T tau_0 = tau_0 - J^T (J^#)^T tau_0. (J^#)^T tau_0 is the solution y of (J W J^T) y = J W
/// tau_0, with W = 1 for the pseudo-inverse and M^-1 for the dynamically consistent inverse.
void project(Inverse inverse, const double (&q)[nv], const double (&tau_0)[nv],
             const double (&J)[kRows * nv], double (&projected)[nv]) {
  double y[kRows] = {};
  double A[kRows * kRows] = {};
  double W_tau[nv];
  std::copy(std::begin(tau_0), std::end(tau_0), std::begin(W_tau));
  if (inverse == Inverse::pseudo) {
    for (int i = 0; i < kRows * kRows; ++i) {
      for (int k = 0; k < nv; ++k) {
        A[i] += J[i / kRows * nv + k] * J[i % kRows * nv + k];
      }
    }
  } else {
    double M[nv * nv];
    planar3r::mass_matrix(q, M);
    solve(M, W_tau);
    planar3r::lambda_inverse(q, A);
  }
  for (int row = 0; row < kRows; ++row) {
    for (int k = 0; k < nv; ++k) {
      y[row] -= J[row * nv + k] * W_tau[k];
    }
  }
  solve(A, y);
  std::copy(std::begin(tau_0), std::end(tau_0), std::begin(projected));
  core::add_task_torque<kRows, nv>(J, y, projected);
}

double tip_of(const double (&q)[nv], double (&tip)[3]) {
  double rotation[9];
  planar3r::forward_kinematics(q, tip, rotation);
  double goal[3];
  planar3r::forward_kinematics(kStart, goal, rotation);
  return std::hypot(tip[0] - goal[0], tip[1] - goal[1]);
}

/// tau = J^T F + N^T tau_0 (Chang eq. 2.2) with F = Lambda (xdd_cmd - Jd qd + J M^-1 b). The
/// Coriolis forces in the null space are not compensated, so with the dynamically consistent
/// inverse its motion keeps its energy.
Torques control(Inverse inverse, const double (&q)[nv], const double (&qd)[nv]) {
  double J[kRows * nv];
  double bias[kRows];
  double tip[3];
  double goal[3];
  double rotation[9];
  planar3r::jacobian(q, J);
  planar3r::bias_acceleration(q, qd, bias);
  planar3r::forward_kinematics(q, tip, rotation);
  planar3r::forward_kinematics(kStart, goal, rotation);
  double free[nv];  // M^-1 b, the negative of the acceleration due to velocities
  double M[nv * nv];
  planar3r::nonlinear_effects(q, qd, free);
  planar3r::mass_matrix(q, M);
  solve(M, free);
  double F[kRows];
  for (int row = 0; row < kRows; ++row) {
    F[row] = kTask.kp * (goal[row] - tip[row]) - bias[row];
    for (int k = 0; k < nv; ++k) {
      F[row] += J[row * nv + k] * (free[k] - kTask.kv * qd[k]);
    }
  }
  double Lambda_inv[kRows * kRows];
  planar3r::lambda_inverse(q, Lambda_inv);
  solve(Lambda_inv, F);
  Torques torques;
  core::add_task_torque<kRows, nv>(J, F, torques.task);
  double tau_0[nv];
  for (int i = 0; i < nv; ++i) {
    tau_0[i] = kStiffness * (kAttractor[i] - q[i]);
  }
  project(inverse, q, tau_0, J, torques.posture);
  return torques;
}

/// The arm with a controller that acts at every instant, so that sampling does not affect the
/// result: a system without inputs for the integrator.
template <Inverse inverse>
struct ClosedLoop {
  static constexpr int kCoordinates = planar3r::kCoordinates;
  static constexpr int kVelocities = nv;
  static void forward_dynamics(const double (&q)[nv], const double (&qd)[nv], const double (&)[nv],
                               double (&qdd)[nv]) noexcept {
    const Torques torques = control(inverse, q, qd);
    double tau[nv];
    for (int i = 0; i < nv; ++i) {
      tau[i] = torques.task[i] + torques.posture[i];
    }
    planar3r::forward_dynamics(q, qd, tau, qdd);
  }
};

/// J M^-1 N^T tau_0|, the acceleration of the tip by the null-space torque, m/s^2.
double coupling(Inverse inverse, const double (&q)[nv], const double (&qd)[nv]) {
  double qdd[nv];
  const Torques torques = control(inverse, q, qd);
  std::copy(std::begin(torques.posture), std::end(torques.posture), std::begin(qdd));
  double M[nv * nv];
  double J[kRows * nv];
  planar3r::mass_matrix(q, M);
  planar3r::jacobian(q, J);
  solve(M, qdd);
  double acceleration[kRows] = {};
  for (int i = 0; i < kRows * nv; ++i) {
    acceleration[i / nv] += J[i] * qdd[i % nv];
  }
  return std::hypot(acceleration[0], acceleration[1]);
}

void record(Inverse inverse, double time, const servo::RobotState<nv, nv>& state,
            NullSpaceRun& run) {
  double tip[3];
  const double distance = tip_of(state.q, tip);
  const double felt = coupling(inverse, state.q, state.qd);
  const double row[] = {time, tip[0], tip[1], distance, felt, state.q[0], state.q[1], state.q[2]};
  run.table.append(row);
  NullSpaceFigures& figures = run.figures;
  figures.tip_motion = std::max(figures.tip_motion, distance);
  figures.coupling = std::max(figures.coupling, felt);
  for (int i = 0; i < nv; ++i) {
    figures.joint_motion = std::max(figures.joint_motion, std::fabs(state.q[i] - kStart[i]));
  }
}

template <Inverse inverse>
NullSpaceRun run() {
  NullSpaceRun result{
      report::Table({"time", "tip_x", "tip_y", "distance", "coupling", "q0", "q1", "q2"},
                    kSteps + 1),
      {}};
  servo::RobotState<nv, nv> state;
  std::copy(std::begin(kStart), std::end(kStart), std::begin(state.q));
  const double none[nv] = {};
  for (int step = 0; step <= kSteps; ++step) {
    record(inverse, step * kStep, state, result);
    servo::integrate_runge_kutta<ClosedLoop<inverse>>({}, none, kStep, state);
  }
  return result;
}

report::PlotPanel tip_panel(const std::string& title, const report::Table& table) {
  return {
      title, "position (m)", {{"x", table.column(1), false}, {"y", table.column(2), false}}, 0.1};
}

}  // namespace

NullSpaceRun run_null_space(Inverse inverse) {
  return inverse == Inverse::pseudo ? run<Inverse::pseudo>() : run<Inverse::dynamic_consistent>();
}

std::string null_space_summary(const NullSpaceRun& pseudo, const NullSpaceRun& consistent) {
  std::string text;
  const auto line = [&text](const char* name, const NullSpaceFigures& figures) {
    text +=
        fmt::format("{:<32} tip moves {:.3e} m, coupling {:.3e} m/s^2, joints swing {:.2f} rad\n",
                    name, figures.tip_motion, figures.coupling, figures.joint_motion);
  };
  line("pseudo-inverse (fig. 2.4)", pseudo.figures);
  line("dynamically consistent (fig. 2.5)", consistent.figures);
  return text;
}

report::Plot null_space_figure(const NullSpaceRun& pseudo, const NullSpaceRun& consistent) {
  report::Plot plot;
  plot.title = "Null-space motion of a 3R arm whose tip is to stay (Chang fig. 2.4, 2.5)";
  plot.x_label = "time (s)";
  plot.x = pseudo.table.column(0);
  plot.panels.push_back(tip_panel("Tip, pseudo-inverse", pseudo.table));
  plot.panels.push_back(tip_panel("Tip, dynamically consistent inverse", consistent.table));
  report::PlotPanel joints{"Joints, dynamically consistent inverse", "angle (rad)", {}, 0.0};
  for (std::size_t i = 0; i < nv; ++i) {
    joints.lines.push_back({fmt::format("q{}", i + 1), consistent.table.column(5 + i), false});
  }
  plot.panels.push_back(joints);
  return plot;
}

bool null_space_claim_holds(const NullSpaceRun& pseudo, const NullSpaceRun& consistent) {
  return consistent.figures.tip_motion < 1e-9 && pseudo.figures.tip_motion > 1e-2 &&
         consistent.figures.joint_motion > 0.2 && pseudo.figures.joint_motion > 0.2;
}

}  // namespace treeline::experiments
