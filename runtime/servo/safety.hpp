#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "servo/robot_proxy.hpp"

namespace treeline::servo {

enum class FaultKind : std::uint8_t {
  none,
  position_limit,  ///< rad or m
  velocity_limit,  ///< rad/s or m/s
  torque_limit,    ///< N m or N, for the command
  state_not_finite,
  torque_not_finite,
  deadline,        ///< too many consecutive cycles overran their tick
  robot_gone,      ///< the proxy is no longer connected
  emergency_stop,  ///< requested by the front end
  stalled,         ///< a cycle was late by more than `SafetyLimits::longest_delay`, s
  jump,            ///< q moves otherwise than qd says: rad or m
  moved,           ///< dragged away while it should stand
  fell,            ///< a robot that stood on its feet lies
  following,       ///< a reference is left behind by so much, rad or m
};

/// The reason why the loop went to its safe state.
struct Fault {
  FaultKind kind = FaultKind::none;
  int index = -1;      ///< index of the coordinate, if the fault concerns one
  double value = 0.0;  ///< measured or commanded value
  double limit = 0.0;  ///< allowed value
  explicit operator bool() const noexcept { return kind != FaultKind::none; }
};

/// rad or m that references may be away, and half of it once they stand, see `find_left_behind`.
inline constexpr double kFollowing = 0.3;

/// Limits per coordinate (position) and per velocity; unlimited unless set.
template <int nq, int nv>
struct SafetyLimits {
  std::array<double, static_cast<std::size_t>(nq)> lower;
  std::array<double, static_cast<std::size_t>(nq)> upper;
  std::array<double, static_cast<std::size_t>(nv)> velocity;
  std::array<double, static_cast<std::size_t>(nv)> torque;
  int overruns_in_a_row = 3;      ///< allowed number; one more is a fault
  double longest_delay = 0.05;    ///< s that a cycle may be late
  double jump = 0.05;             ///< rad or m of q that qd need not explain
  double following = kFollowing;  ///< rad or m that references may be away

  SafetyLimits() noexcept {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    lower.fill(-kInfinity);
    upper.fill(kInfinity);
    velocity.fill(kInfinity);
    torque.fill(kInfinity);
  }
};

/// The limits that a generated NAME_joints.hpp lists: of positions, speeds and torques.
template <std::size_t nq, std::size_t nv>
SafetyLimits<static_cast<int>(nq), static_cast<int>(nv)> limits_of(const double (&lower)[nq],
                                                                   const double (&upper)[nq],
                                                                   const double (&velocity)[nv],
                                                                   const double (&torque)[nv]) {
  SafetyLimits<static_cast<int>(nq), static_cast<int>(nv)> limits;
  std::copy(lower, lower + nq, limits.lower.begin());
  std::copy(upper, upper + nq, limits.upper.begin());
  std::copy(velocity, velocity + nv, limits.velocity.begin());
  std::copy(torque, torque + nv, limits.torque.begin());
  return limits;
}

/// Returns a fault for the first measured number that is not finite.
template <int nq, int nv>
Fault check_finite(const RobotState<nq, nv>& state) noexcept {
  for (int i = 0; i < nq; ++i) {
    if (!std::isfinite(state.q[i])) return {FaultKind::state_not_finite, i};
  }
  for (int i = 0; i < nv; ++i) {
    if (!std::isfinite(state.qd[i])) return {FaultKind::state_not_finite, i};
  }
  return {};
}

/// Returns a fault for the first measured number that exceeds its limit.
template <int nq, int nv>
Fault check_state(const SafetyLimits<nq, nv>& limits, const RobotState<nq, nv>& state) noexcept {
  for (int i = 0; i < nq; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (state.q[i] < limits.lower[at] || state.q[i] > limits.upper[at]) {
      const bool low = state.q[i] < limits.lower[at];
      return {FaultKind::position_limit, i, state.q[i], low ? limits.lower[at] : limits.upper[at]};
    }
  }
  for (int i = 0; i < nv; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (std::fabs(state.qd[i]) > limits.velocity[at]) {
      return {FaultKind::velocity_limit, i, state.qd[i], limits.velocity[at]};
    }
  }
  return {};
}

/// Widens the limits of position to a state that is beyond them, with a small slack. What is beyond
/// then can be led back.
template <int nq, int nv>
void admit(const RobotState<nq, nv>& state, SafetyLimits<nq, nv>& limits) noexcept {
  constexpr double kSlack = 1e-3;  // rad or m
  for (int i = 0; i < nq; ++i) {
    const auto at = static_cast<std::size_t>(i);
    limits.lower[at] = std::fmin(limits.lower[at], state.q[i] - kSlack);
    limits.upper[at] = std::fmax(limits.upper[at], state.q[i] + kSlack);
  }
}

/// Narrows limits that were widened: they follow the state back, and never beyond `own`.
template <int nq, int nv>
void follow_back(const SafetyLimits<nq, nv>& own, const RobotState<nq, nv>& state,
                 SafetyLimits<nq, nv>& limits) noexcept {
  constexpr double kSlack = 1e-3;  // rad or m
  for (int i = 0; i < nq; ++i) {
    const auto at = static_cast<std::size_t>(i);
    limits.lower[at] = std::fmin(own.lower[at], std::fmax(limits.lower[at], state.q[i] - kSlack));
    limits.upper[at] = std::fmax(own.upper[at], std::fmin(limits.upper[at], state.q[i] + kSlack));
  }
}

/// Returns a fault for the first commanded torque that is not finite or exceeds its limit.
template <int nq, int nv>
Fault check_torque(const SafetyLimits<nq, nv>& limits, const double (&tau)[nv]) noexcept {
  for (int i = 0; i < nv; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!std::isfinite(tau[i])) {
      return {FaultKind::torque_not_finite, i};
    }
    if (std::fabs(tau[i]) > limits.torque[at]) {
      return {FaultKind::torque_limit, i, tau[i], limits.torque[at]};
    }
  }
  return {};
}

/// Describes the fault in words, with the coordinate's name if `name` is not empty. Allocates
/// memory, so it must not be called in the loop.
std::string describe(const Fault& fault, const std::string& name = {});

}  // namespace treeline::servo
