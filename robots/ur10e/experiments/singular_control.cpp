#include "singular_control.hpp"

#include "core/ldlt.hpp"
#include "core/singularity.hpp"
#include "ur10e_damped.hpp"
#include "ur10e_exact.hpp"

namespace treeline::ur10e_experiments {
namespace {

constexpr double kDampingRate = 10.0;                          ///< 1/s
constexpr double kScales[6] = {0.6, 0.6, 0.6, 1.0, 1.0, 1.0};  ///< m that correspond to a radian
constexpr double kBorder = 0.1;           ///< smallest singular value below which damping begins
constexpr double kLargestDamping = 0.08;  ///< of damped least squares, in scaled rows

/// qdd = J^T (J J^T + lambda^2)^-1 (xdd - Jd qd - J qdd_0) + qdd_0. lambda^2 grows as the smallest
/// singular value falls below a border.
void control_least_squares(const double (&q)[6], const double (&qd)[6], const double (&qdd_0)[6],
                           const double (&xdd_cmd)[6], double (&tau)[6]) {
  double J_given[36];
  double J[36];
  double x[6];
  ur10e::jacobian(q, J_given);
  ur10e::bias_acceleration(q, qd, x);
  core::scale_rows<6, 6>(J_given, kScales, J);
  const auto all = core::singular_directions<6, 6>(J, core::SingularRegion<double>{});
  const double ratio = all.values[5] < kBorder ? all.values[5] / kBorder : 1.0;
  double A[36] = {};
  double qdd[6];
  for (int i = 0; i < 6; ++i) {
    x[i] = (xdd_cmd[i] - x[i]) / kScales[i];
    for (int k = 0; k < 6; ++k) {
      x[i] -= J[6 * i + k] * qdd_0[k];
      for (int j = 0; j < 6; ++j) {
        A[6 * i + j] += J[6 * i + k] * J[6 * j + k];
      }
    }
    A[7 * i] += kLargestDamping * kLargestDamping * (1.0 - ratio * ratio);
    qdd[i] = qdd_0[i];
  }
  core::ldlt_factor<6>(A);
  core::ldlt_solve(A, x);
  core::add_task_torque<6, 6>(J, x, qdd);
  ur10e::inverse_dynamics(q, qd, qdd, tau);
}

}  // namespace

const char* name_of(Law law) {
  switch (law) {
    case Law::exact:
      return "table 6.1 as it stands";
    case Law::least_squares:
      return "damped least squares";
    case Law::damped:
      return "damped by directions";
  }
  return "";
}

double control(Law law, const double (&q)[6], const double (&qd)[6], const double (&xdd_cmd)[6],
               double (&tau)[6]) {
  double qdd_0[6];
  for (int i = 0; i < 6; ++i) {
    qdd_0[i] = -kDampingRate * qd[i];
  }
  const double ease = ur10e::damped_control_torque(q, qd, qdd_0, xdd_cmd, tau);
  if (law == Law::exact) {
    ur10e_exact::control_torque(q, qd, qdd_0, xdd_cmd, tau);
  } else if (law == Law::least_squares) {
    control_least_squares(q, qd, qdd_0, xdd_cmd, tau);
  }
  return ease;
}

}  // namespace treeline::ur10e_experiments
