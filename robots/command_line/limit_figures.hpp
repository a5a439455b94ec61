#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "core/quadratic_program.hpp"
#include "servo/safety.hpp"

namespace treeline::experiments {

/// What a controller with `limited_control_torque` commands, of all cycles.
struct LimitFigures {
  double base_torque = 0.0;  ///< largest entry of tau at the base, N or N m
  double torque = 0.0;       ///< largest torque of a motor as a share of its limit
  double beyond = -1e9;      ///< most by which forces are beyond a cone, N
  double slack = 0.0;        ///< most by which cones were widened, N
  int limited = 0;           ///< cycles in which a limit was reached
  int unsolved = 0;          ///< cycles whose program was not solved
  int iterations = 0;        ///< most of a cycle

  /// Takes the figures of one cycle, or of others.
  void add(const LimitFigures& other) noexcept;
  /// Whether motors alone act, and within limits.
  [[nodiscard]] bool kept() const noexcept;
};

/// Three lines for a summary.
std::string describe_limits(const LimitFigures& figures);

/// Two rows of a page's table: forces beyond a cone, to a power of ten, since they are rounding,
/// and limits reached.
std::string rows_of_limits(const LimitFigures& figures);

/// A fault in words, with the joint that it is about: of a coordinate, of a velocity or of neither,
/// by the lists of NAME_joints.hpp.
template <std::size_t nq, std::size_t nv>
std::string describe_fault(const servo::Fault& fault, const char* const (&coordinate_joints)[nq],
                           const char* const (&velocity_joints)[nv]) {
  const char* joint = "";
  if (fault.kind == servo::FaultKind::position_limit) {
    joint = coordinate_joints[fault.index];
  } else if (fault.kind == servo::FaultKind::velocity_limit ||
             fault.kind == servo::FaultKind::torque_limit) {
    joint = velocity_joints[fault.index];
  }
  return servo::describe(fault, joint);
}

/// The largest torque of a motor as a share of its limit; the first six entries are of a base
/// without motors.
template <std::size_t nv>
double largest_share(const double (&tau)[nv], const double (&efforts)[nv]) noexcept {
  double most = 0.0;
  for (std::size_t i = 6; i < nv; ++i) most = std::max(most, std::fabs(tau[i]) / efforts[i]);
  return most;
}

/// The figures of one cycle: its torques, forces `f` of supports, their `limits`, and what became
/// of these. Generated types.
template <std::size_t nv, std::size_t held, class Limits, class Limited>
LimitFigures limit_figures(const double (&tau)[nv], const double (&efforts)[nv],
                           const double (&f)[held], const Limits& limits,
                           const Limited& limited) noexcept {
  LimitFigures figures;
  for (std::size_t i = 0; i < 6; ++i) {
    figures.base_torque = std::max(figures.base_torque, std::fabs(tau[i]));
  }
  figures.torque = largest_share(tau, efforts);
  for (const auto& cone : limits.cones) {
    double value = -cone.bound;
    for (int k = 0; k < cone.count; ++k) value += cone.coefficients[k] * f[cone.first + k];
    figures.beyond = std::max(figures.beyond, value);
  }
  figures.slack = limited.slack;
  figures.limited = limited.limited ? 1 : 0;
  figures.unsolved = limited.status == static_cast<int>(core::QuadraticStatus::solved) ? 0 : 1;
  figures.iterations = limited.iterations;
  return figures;
}

}  // namespace treeline::experiments
