#include "singular_control.hpp"

#include "core/ldlt.hpp"
#include "puma560_exact.hpp"

namespace treeline::experiments {
namespace {

constexpr core::SingularRegion<double> kRegion{0.04, 0.12};
constexpr core::NullMotionGains<double> kNullMotion{100.0, 20.0, 3.0};
constexpr double kUrge = 0.05;           ///< rad, for turn_away
constexpr double kLargestDamping = 0.1;  ///< of damped least squares, in scaled rows

/// out = A x for a row-major 6 x 6 matrix.
void multiply(const double (&A)[36], const double (&x)[6], double (&out)[6]) {
  for (int i = 0; i < 6; ++i) {
    out[i] = 0.0;
    for (int k = 0; k < 6; ++k) {
      out[i] += A[6 * i + k] * x[k];
    }
  }
}

/// Derivative dJ/ds of the scaled Jacobian along the unit motion n, by a central difference of the
/// generated Jacobian. Its error, 1e-8 of the Jacobian, is far below what types and laws resolve.
void jacobian_change(const double (&q)[6], const double (&n)[6], double (&dJ)[36]) {
  constexpr double kStep = 1e-4;
  double moved[6];
  double ahead[36];
  double behind[36];
  for (int i = 0; i < 6; ++i) {
    moved[i] = q[i] + kStep * n[i];
  }
  puma560::jacobian(moved, ahead);
  for (int i = 0; i < 6; ++i) {
    moved[i] = q[i] - kStep * n[i];
  }
  puma560::jacobian(moved, behind);
  double change[36];
  for (int i = 0; i < 36; ++i) {
    change[i] = (ahead[i] - behind[i]) / (2.0 * kStep);
  }
  core::scale_rows<6, 6>(change, kScales, dJ);
}

WeakestDirection look(const double (&q)[6], const double (&J)[36],
                      const core::SingularDirections<6, 6, double>& all, int i) {
  constexpr double kReference[6] = {0, 0, 1, 1, 0, 0};
  WeakestDirection found;
  found.all = all;
  core::lost_motion(all, i, kReference, found.motion);
  double dJ[36];
  jacobian_change(q, found.motion, dJ);
  found.lost = core::lost_direction(all, i, J, dJ, found.motion);
  found.type = core::singularity_type(found.lost);
  return found;
}

/// qdd_0: the null motions of all lost directions, each by its type and by the share that is lost.
void null_motions(const double (&q)[6], const double (&qd)[6], const double (&J)[36],
                  const core::SingularDirections<6, 6, double>& all, const ToolCommand& command,
                  double branch, double (&qdd_0)[6]) {
  double wanted[6];
  for (int i = 0; i < 6; ++i) {
    wanted[i] = command.displacement[i] / kScales[i];
  }
  for (int i = 0; i < 6; ++i) {
    if (all.shares[i] == 1.0) {
      continue;
    }
    const WeakestDirection found = look(q, J, all, i);
    const double* u = all.directions + 6 * i;
    double speed = 0.0;
    double along = 0.0;
    for (int k = 0; k < 6; ++k) {
      speed += found.motion[k] * qd[k];
      along += u[k] * wanted[k];
    }
    const double acceleration =
        found.type == core::SingularityType::moves_along
            ? core::drive_along(kNullMotion, found.lost, along, branch, speed)
            : core::turn_away(kNullMotion, u, found.lost, wanted, kUrge, speed);
    for (int k = 0; k < 6; ++k) {
      qdd_0[k] += (1.0 - all.shares[i]) * acceleration * found.motion[k];
    }
  }
}

void control_singular(const double (&q)[6], const double (&qd)[6], const ToolCommand& command,
                      double branch, double (&tau)[6]) {
  double J_given[36];
  double J[36];
  double bias[6];
  double Lambda_inv[36];
  puma560::jacobian(q, J_given);
  puma560::bias_acceleration(q, qd, bias);
  puma560::lambda_inverse(q, Lambda_inv);
  core::scale_rows<6, 6>(J_given, kScales, J);
  const auto all = core::singular_directions<6, 6>(J, kRegion);
  double qdd_0[6] = {};
  null_motions(q, qd, J, all, command, branch, qdd_0);
  double missing[6];
  multiply(J_given, qdd_0, missing);
  for (int i = 0; i < 6; ++i) {
    missing[i] = command.acceleration[i] - bias[i] - missing[i];
  }
  double F[6];
  core::regular_task_force<6, 6>(all, kScales, Lambda_inv, missing, F);
  puma560::inverse_dynamics(q, qd, qdd_0, tau);
  core::add_task_torque<6, 6>(J_given, F, tau);
}

/// qdd = J^T (J J^T + lambda^2)^-1 (xdd - Jd qd + kv J qd) - kv qd, so that motion outside the
/// inverse is damped. lambda^2 grows as the smallest singular value falls below a border.
void control_damped(const double (&q)[6], const double (&qd)[6], const ToolCommand& command,
                    double (&tau)[6]) {
  constexpr double kDampingRate = 20.0;
  double J_given[36];
  double J[36];
  double bias[6];
  puma560::jacobian(q, J_given);
  puma560::bias_acceleration(q, qd, bias);
  core::scale_rows<6, 6>(J_given, kScales, J);
  const auto all = core::singular_directions<6, 6>(J, kRegion);
  const double ratio = all.values[5] < kRegion.outer ? all.values[5] / kRegion.outer : 1.0;
  double A[36] = {};
  double velocity[6];
  double x[6];
  multiply(J, qd, velocity);
  for (int i = 0; i < 6; ++i) {
    x[i] = (command.acceleration[i] - bias[i]) / kScales[i] + kDampingRate * velocity[i];
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) {
        A[6 * i + j] += J[6 * i + k] * J[6 * j + k];
      }
    }
    A[7 * i] += kLargestDamping * kLargestDamping * (1.0 - ratio * ratio);
  }
  core::ldlt_factor<6>(A);
  core::ldlt_solve(A, x);
  double qdd[6];
  for (int k = 0; k < 6; ++k) {
    qdd[k] = -kDampingRate * qd[k];
  }
  core::add_task_torque<6, 6>(J, x, qdd);
  puma560::inverse_dynamics(q, qd, qdd, tau);
}

}  // namespace

const char* name_of(Strategy strategy) {
  switch (strategy) {
    case Strategy::none:
      return "without strategy";
    case Strategy::damped:
      return "damped least squares";
    case Strategy::singular:
      return "singularity control";
  }
  return "";
}

WeakestDirection look_at_direction(const double (&q)[6], int i) {
  double J_given[36];
  double J[36];
  puma560::jacobian(q, J_given);
  core::scale_rows<6, 6>(J_given, kScales, J);
  return look(q, J, core::singular_directions<6, 6>(J, kRegion), i);
}

void control(Strategy strategy, const double (&q)[6], const double (&qd)[6],
             const ToolCommand& command, double branch, double (&tau)[6]) {
  switch (strategy) {
    case Strategy::none: {
      const double none[6] = {};
      puma560_exact::control_torque(q, qd, none, command.acceleration, tau);
      return;
    }
    case Strategy::damped:
      return control_damped(q, qd, command, tau);
    case Strategy::singular:
      return control_singular(q, qd, command, branch, tau);
  }
}

}  // namespace treeline::experiments
