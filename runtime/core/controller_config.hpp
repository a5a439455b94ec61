#pragma once
// Whether the numbers of a controller's configuration can be used. Each comparison is false for
// NaN. C++17, freestanding, fixed size.

#include "core/controller_safety.hpp"

namespace treeline::core {

/// Members of a configuration, as `ConfigFault` names them.
enum class ConfigField : int32_t {
  sound,
  period,
  lower,
  upper,
  speed,
  torque,
  torque_rate,
  position_margin,
  speed_margin,
  joint_frequency,
  joint_damping,
  task_frequency,
  task_damping,
  posture_frequency,
  point_speed,
  point_turn,
  force_gain,
  force_rate,
  force_damping,
  largest_force,
  brake_damping,
  hold_frequency,
  hold_reach,
  rest_speed,
  jump,
  following,
  fade,
  saturation,
  stale_ticks,
  blind_ticks,
  speed_rise,
  comply_damping,
  joint_stiffness,
  joint_viscosity,
  point_stiffness,
  point_viscosity,
};

/// The first member that is not sound, and which of its numbers; 0 and 0 where all are.
struct ConfigFault {
  int32_t field;
  int32_t index;
};

constexpr ConfigFault not_sound(ConfigField field, int32_t index) noexcept {
  return {static_cast<int32_t>(field), index};
}

/// Whether `x` is from `least` to `most`.
template <class Real>
constexpr bool is_from(Real x, Real least, Real most) noexcept {
  return (x >= least) && (x <= most);
}

/// Whether `x` is positive and finite.
template <class Real>
constexpr bool is_positive(Real x) noexcept {
  return is_finite(x) && (x > Real(0));
}

/// Limits and gains of the joints. `fastest` is the largest rate, 1/s, that a step can follow.
template <class Robot>
inline ConfigFault check_joint_config(const typename Robot::Config& config,
                                      RealOf<Robot> fastest) noexcept {
  for (int i = 0; i < Robot::kJoints; ++i) {
    if (!is_finite(config.lower[i])) {
      return not_sound(ConfigField::lower, i);
    }
    if (!(is_finite(config.upper[i]) && (config.lower[i] < config.upper[i]))) {
      return not_sound(ConfigField::upper, i);
    }
    if (!is_positive(config.speed[i])) {
      return not_sound(ConfigField::speed, i);
    }
    if (!is_positive(config.torque[i])) {
      return not_sound(ConfigField::torque, i);
    }
    if (!is_positive(config.torque_rate[i])) {
      return not_sound(ConfigField::torque_rate, i);
    }
    if (!is_from(config.joint_frequency[i], RealOf<Robot>(0), fastest)) {
      return not_sound(ConfigField::joint_frequency, i);
    }
    if (!is_from(config.joint_damping[i], RealOf<Robot>(0), RealOf<Robot>(10))) {
      return not_sound(ConfigField::joint_damping, i);
    }
  }
  return {0, 0};
}

/// Gains and limits of speed of tasks.
template <class Robot>
inline ConfigFault check_task_config(const typename Robot::Config& config,
                                     RealOf<Robot> fastest) noexcept {
  for (int i = 0; i < (6 * Robot::kPoints); ++i) {
    if (!is_from(config.task_frequency[i], RealOf<Robot>(0), fastest)) {
      return not_sound(ConfigField::task_frequency, i);
    }
    if (!is_from(config.task_damping[i], RealOf<Robot>(0), RealOf<Robot>(10))) {
      return not_sound(ConfigField::task_damping, i);
    }
  }
  for (int i = 0; i < Robot::kJoints; ++i) {
    if (!is_from(config.posture_frequency[i], RealOf<Robot>(0), fastest)) {
      return not_sound(ConfigField::posture_frequency, i);
    }
  }
  if (!is_positive(config.point_speed)) {
    return not_sound(ConfigField::point_speed, 0);
  }
  if (!is_positive(config.point_turn)) {
    return not_sound(ConfigField::point_turn, 0);
  }
  return {0, 0};
}

/// Gains of forces. The integral has to be slower than the damping (Routh).
template <class Robot>
inline ConfigFault check_force_config(const typename Robot::Config& config,
                                      RealOf<Robot> fastest) noexcept {
  if (!is_from(config.force_gain, RealOf<Robot>(0), RealOf<Robot>(100))) {
    return not_sound(ConfigField::force_gain, 0);
  }
  if (!((config.force_rate >= RealOf<Robot>(0)) && (config.force_rate < config.force_damping))) {
    return not_sound(ConfigField::force_rate, 0);
  }
  if (!is_from(config.force_damping, RealOf<Robot>(0), fastest)) {
    return not_sound(ConfigField::force_damping, 0);
  }
  if (!(is_finite(config.largest_force) && (config.largest_force >= RealOf<Robot>(0)))) {
    return not_sound(ConfigField::largest_force, 0);
  }
  return {0, 0};
}

/// What brakes, and what is a fault.
template <class Robot>
inline ConfigFault check_safety_config(const typename Robot::Config& config,
                                       RealOf<Robot> fastest) noexcept {
  if (!is_from(config.position_margin, RealOf<Robot>(0), RealOf<Robot>(10))) {
    return not_sound(ConfigField::position_margin, 0);
  }
  if (!is_from(config.speed_margin, RealOf<Robot>(0), RealOf<Robot>(10))) {
    return not_sound(ConfigField::speed_margin, 0);
  }
  if (!(is_positive(config.brake_damping) && (config.brake_damping <= fastest))) {
    return not_sound(ConfigField::brake_damping, 0);
  }
  if (!(is_positive(config.hold_frequency) && (config.hold_frequency <= fastest))) {
    return not_sound(ConfigField::hold_frequency, 0);
  }
  if (!is_positive(config.hold_reach)) {
    return not_sound(ConfigField::hold_reach, 0);
  }
  if (!is_positive(config.rest_speed)) {
    return not_sound(ConfigField::rest_speed, 0);
  }
  if (!is_positive(config.jump)) {
    return not_sound(ConfigField::jump, 0);
  }
  if (!is_positive(config.following)) {
    return not_sound(ConfigField::following, 0);
  }
  if (!is_from(config.fade, RealOf<Robot>(0), RealOf<Robot>(10))) {
    return not_sound(ConfigField::fade, 0);
  }
  if (!((config.saturation == Robot::kScale) || (config.saturation == Robot::kClamp))) {
    return not_sound(ConfigField::saturation, 0);
  }
  if (!is_from(config.speed_rise, RealOf<Robot>(0), RealOf<Robot>(10))) {
    return not_sound(ConfigField::speed_rise, 0);
  }
  if (!(config.stale_ticks >= 0)) {
    return not_sound(ConfigField::stale_ticks, 0);
  }
  if (!(config.blind_ticks >= 0)) {
    return not_sound(ConfigField::blind_ticks, 0);
  }
  return {0, 0};
}

/// Whether `x` is finite and not negative.
template <class Real>
constexpr bool is_not_negative(Real x) noexcept {
  return is_finite(x) && (x >= Real(0));
}

/// Springs and dampers of compliance.
template <class Robot>
inline ConfigFault check_compliance_config(const typename Robot::Config& config,
                                           RealOf<Robot> fastest) noexcept {
  if (!is_from(config.comply_damping, RealOf<Robot>(0), fastest)) {
    return not_sound(ConfigField::comply_damping, 0);
  }
  for (int i = 0; i < Robot::kJoints; ++i) {
    if (!is_not_negative(config.joint_stiffness[i])) {
      return not_sound(ConfigField::joint_stiffness, i);
    }
    if (!is_not_negative(config.joint_viscosity[i])) {
      return not_sound(ConfigField::joint_viscosity, i);
    }
  }
  if constexpr (Robot::kForce) {
    for (int i = 0; i < (6 * Robot::kPoints); ++i) {
      if (!is_not_negative(config.point_stiffness[i])) {
        return not_sound(ConfigField::point_stiffness, i);
      }
      if (!is_not_negative(config.point_viscosity[i])) {
        return not_sound(ConfigField::point_viscosity, i);
      }
    }
  }
  return {0, 0};
}

/// The first member of the configuration that cannot be used.
template <class Robot>
inline ConfigFault check_config(const typename Robot::Config& config) noexcept {
  if (!(is_positive(config.period) && (config.period <= RealOf<Robot>(1)))) {
    return not_sound(ConfigField::period, 0);
  }
  const RealOf<Robot> fastest = RealOf<Robot>(0.5001) / config.period;
  ConfigFault fault = check_joint_config<Robot>(config, fastest);
  if constexpr (Robot::kTask) {
    fault = (fault.field == 0) ? check_task_config<Robot>(config, fastest) : fault;
  }
  if constexpr (Robot::kForce) {
    fault = (fault.field == 0) ? check_force_config<Robot>(config, fastest) : fault;
  }
  fault = (fault.field == 0) ? check_compliance_config<Robot>(config, fastest) : fault;
  return (fault.field == 0) ? check_safety_config<Robot>(config, fastest) : fault;
}

}  // namespace treeline::core
