#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "drive/drive_controller.hpp"
#include "drive/robot_library.hpp"
#include "servo/loop.hpp"

namespace treeline::drive {

/// More than any time (s) or distance (rad or m): a controller of the robot's own goes on by
/// itself, and knows when it hears nothing. So it is not asked whether cycles are late, how near it
/// comes to goals, nor whether it stands.
inline constexpr double kAnything = 1e9;

template <class F>
servo::StateOf<F> start_of(const LoopOptions& options) noexcept {
  servo::StateOf<F> state;
  std::copy_n(options.start, F::kCoordinates, state.q);
  return state;
}

inline servo::LoopSettings loop_settings(const LoopOptions& options) noexcept {
  servo::LoopSettings settings;
  settings.rate = options.rate;
  settings.messages_per_cycle = 8;
  if (options.robot.has_controller()) settings.brake.reach = kAnything;
  return settings;
}

template <int nq, int nv>
ControlSettings<nq, nv> control_settings(const LoopOptions& options) noexcept {
  ControlSettings<nq, nv> settings;
  std::copy_n(options.lower, nq, settings.lower.begin());
  std::copy_n(options.upper, nq, settings.upper.begin());
  std::copy_n(options.home != nullptr ? options.home : options.start, nq, settings.home.begin());
  std::copy_n(options.velocity, nv, settings.velocity.begin());
  std::copy_n(options.torque, nv, settings.torque.begin());
  settings.period = 1.0 / options.rate;
  settings.pull_stiffness = options.pull_stiffness;
  settings.pull_force = options.pull_force;
  settings.only_leads = options.robot.has_controller();
  settings.surroundings = options.surroundings;
  settings.reference = options.reference;
  return settings;
}

template <int nq, int nv>
servo::SafetyLimits<nq, nv> safety_limits(const LoopOptions& options) noexcept {
  servo::SafetyLimits<nq, nv> limits;
  for (int i = 0; i < nq; ++i) {
    const auto at = static_cast<std::size_t>(i);
    limits.lower[at] = options.lower[i] - options.beyond;
    limits.upper[at] = options.upper[i] + options.beyond;
  }
  std::copy_n(options.velocity, nv, limits.velocity.begin());
  std::copy_n(options.torque, nv, limits.torque.begin());
  limits.overruns_in_a_row = options.overruns_in_a_row;
  limits.longest_delay = options.longest_delay;
  if (options.robot.has_controller()) {
    limits.jump = limits.following = limits.longest_delay = kAnything;
    limits.overruns_in_a_row = std::numeric_limits<int>::max();
  }
  return limits;
}

}  // namespace treeline::drive
