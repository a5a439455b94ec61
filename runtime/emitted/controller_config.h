#pragma once
// Whether the numbers of a controller's configuration can be used. Each comparison is
// false for NaN.

#include "controller_numbers.h"
#include "controller_robot.h"

TL_INLINE bool tl_is_from(real x, real least, real most) {
  return (x >= least) && (x <= most);
}

/// Whether x is positive and finite.
TL_INLINE bool tl_is_positive(real x) {
  return tl_is_number(x) && (x > TL_ZERO);
}

/// Whether x is finite and not negative.
TL_INLINE bool tl_is_not_negative(real x) {
  return tl_is_number(x) && (x >= TL_ZERO);
}

#if TL_CURRENT
/// Whether the current of a joint is a number, up to its limit of torque.
TL_INLINE bool tl_tells_current(const TlConfig* config, int32_t i) {
  const real by_ampere = config->torque_per_ampere[i];
  return tl_is_number(by_ampere) && (tl_magnitude(by_ampere) > TL_ZERO) &&
      tl_is_number(config->torque[i] / by_ampere);
}
#endif

/// Limits and gains of the joints: the first member that is not sound, 0 where all
/// are, and which of its numbers. `fastest` is the largest rate, 1/s, that a step can
/// follow.
TL_INLINE int32_t tl_check_joints(
    const TlConfig* config, real fastest, int32_t* index) {
  int32_t field = TL_CONFIG_SOUND;
  for (int32_t i = 0; (i < TL_JOINTS) && (field == TL_CONFIG_SOUND); ++i) {
    *index = i;
    if (!tl_is_number(config->lower[i])) {
      field = TL_CONFIG_LOWER;
    } else if (!(tl_is_number(config->upper[i]) &&
                   (config->lower[i] < config->upper[i]))) {
      field = TL_CONFIG_UPPER;
    } else if (!tl_is_positive(config->speed[i])) {
      field = TL_CONFIG_SPEED;
    } else if (!tl_is_positive(config->torque[i])) {
      field = TL_CONFIG_TORQUE;
    } else if (!tl_is_positive(config->torque_rate[i])) {
      field = TL_CONFIG_TORQUE_RATE;
#if TL_CURRENT
    } else if (!tl_tells_current(config, i)) {
      field = TL_CONFIG_TORQUE_PER_AMPERE;
#endif
    } else if (!tl_is_from(config->joint_frequency[i], TL_ZERO, fastest)) {
      field = TL_CONFIG_JOINT_FREQUENCY;
    } else if (!tl_is_from(config->joint_damping[i], TL_ZERO, TL_TEN)) {
      field = TL_CONFIG_JOINT_DAMPING;
    } else {
      // They can be used.
    }
  }
  return field;
}

#if TL_BEHAVES
/// Shares of tasks in behaviours.
TL_INLINE int32_t tl_check_behaviours(const TlConfig* config, int32_t* index) {
  int32_t field = TL_CONFIG_SOUND;
  for (int32_t i = 0;
       (i < (TL_BEHAVIOURS * TL_SHARE_COUNT)) && (field == TL_CONFIG_SOUND); ++i) {
    *index = i;
    if (!tl_is_from(config->behaviour_share[i], TL_ZERO, TL_ONE)) {
      field = TL_CONFIG_BEHAVIOUR_SHARE;
    }
  }
  return field;
}
#endif

#if TL_TASK
/// Gains and limits of speed of tasks.
TL_INLINE int32_t tl_check_task(
    const TlConfig* config, real fastest, int32_t* index) {
  int32_t field = TL_CONFIG_SOUND;
  for (int32_t i = 0; (i < (6 * TL_POINTS)) && (field == TL_CONFIG_SOUND); ++i) {
    *index = i;
    if (!tl_is_from(config->task_frequency[i], TL_ZERO, fastest)) {
      field = TL_CONFIG_TASK_FREQUENCY;
    } else if (!tl_is_from(config->task_damping[i], TL_ZERO, TL_TEN)) {
      field = TL_CONFIG_TASK_DAMPING;
    } else {
      // They can be used.
    }
  }
  for (int32_t i = 0; (i < TL_JOINTS) && (field == TL_CONFIG_SOUND); ++i) {
    *index = i;
    if (!tl_is_from(config->posture_frequency[i], TL_ZERO, fastest)) {
      field = TL_CONFIG_POSTURE_FREQUENCY;
    } else {
      // They can be used.
    }
  }
  if (field == TL_CONFIG_SOUND) {
    *index = 0;
    if (!tl_is_positive(config->point_speed)) {
      field = TL_CONFIG_POINT_SPEED;
    } else if (!tl_is_positive(config->point_turn)) {
      field = TL_CONFIG_POINT_TURN;
    } else {
      // They can be used.
    }
  }
  return field;
}
#endif

#if TL_FORCE
/// Gains of forces. The integral has to be slower than the damping (Routh).
TL_INLINE int32_t tl_check_force(
    const TlConfig* config, real fastest, int32_t* index) {
  int32_t field = TL_CONFIG_SOUND;
  *index = 0;
  if (!tl_is_from(config->force_gain, TL_ZERO, TL_REAL(100.0))) {
    field = TL_CONFIG_FORCE_GAIN;
  } else if (!((config->force_rate >= TL_ZERO) &&
                 (config->force_rate < config->force_damping))) {
    field = TL_CONFIG_FORCE_RATE;
  } else if (!tl_is_from(config->force_damping, TL_ZERO, fastest)) {
    field = TL_CONFIG_FORCE_DAMPING;
  } else if (!tl_is_not_negative(config->largest_force)) {
    field = TL_CONFIG_LARGEST_FORCE;
  } else {
    // They can be used.
  }
  return field;
}
#endif

/// Springs and dampers of compliance.
TL_INLINE int32_t tl_check_compliance(
    const TlConfig* config, real fastest, int32_t* index) {
  int32_t field = TL_CONFIG_SOUND;
  *index = 0;
  if (!tl_is_from(config->comply_damping, TL_ZERO, fastest)) {
    field = TL_CONFIG_COMPLY_DAMPING;
  }
  for (int32_t i = 0; (i < TL_JOINTS) && (field == TL_CONFIG_SOUND); ++i) {
    *index = i;
    if (!tl_is_not_negative(config->joint_stiffness[i])) {
      field = TL_CONFIG_JOINT_STIFFNESS;
    } else if (!tl_is_not_negative(config->joint_viscosity[i])) {
      field = TL_CONFIG_JOINT_VISCOSITY;
    } else if (!tl_is_from(config->joint_damping_ratio[i], TL_ZERO, TL_TEN)) {
      field = TL_CONFIG_JOINT_DAMPING_RATIO;
    } else {
      // They can be used.
    }
  }
#if TL_FORCE
  for (int32_t i = 0; (i < (6 * TL_POINTS)) && (field == TL_CONFIG_SOUND); ++i) {
    *index = i;
    if (!tl_is_not_negative(config->point_stiffness[i])) {
      field = TL_CONFIG_POINT_STIFFNESS;
    } else if (!tl_is_not_negative(config->point_viscosity[i])) {
      field = TL_CONFIG_POINT_VISCOSITY;
    } else {
      // They can be used.
    }
  }
#endif
  return field;
}

/// What brakes, and what is a fault.
TL_INLINE int32_t tl_check_safety(
    const TlConfig* config, real fastest, int32_t* index) {
  int32_t field = TL_CONFIG_SOUND;
  *index = 0;
  if (!tl_is_from(config->position_margin, TL_ZERO, TL_TEN)) {
    field = TL_CONFIG_POSITION_MARGIN;
  } else if (!tl_is_from(config->speed_margin, TL_ZERO, TL_TEN)) {
    field = TL_CONFIG_SPEED_MARGIN;
  } else if (!(tl_is_positive(config->brake_damping) &&
                 (config->brake_damping <= fastest))) {
    field = TL_CONFIG_BRAKE_DAMPING;
  } else if (!(tl_is_positive(config->hold_frequency) &&
                 (config->hold_frequency <= fastest))) {
    field = TL_CONFIG_HOLD_FREQUENCY;
  } else if (!tl_is_positive(config->hold_reach)) {
    field = TL_CONFIG_HOLD_REACH;
  } else if (!((config->observer == TL_ZERO) ||
                 tl_is_from(config->observer, TL_REAL(3.999) * config->hold_frequency,
                     fastest))) {
    field = TL_CONFIG_OBSERVER;
  } else if (!tl_is_positive(config->rest_speed)) {
    field = TL_CONFIG_REST_SPEED;
  } else if (!tl_is_positive(config->jump)) {
    field = TL_CONFIG_JUMP;
  } else if (!tl_is_positive(config->following)) {
    field = TL_CONFIG_FOLLOWING;
  } else if (!tl_is_from(config->fade, TL_ZERO, TL_TEN)) {
    field = TL_CONFIG_FADE;
  } else if (!((config->saturation == TL_SCALE) ||
                 (config->saturation == TL_CLAMP))) {
    field = TL_CONFIG_SATURATION;
  } else if (!tl_is_from(config->speed_rise, TL_ZERO, TL_TEN)) {
    field = TL_CONFIG_SPEED_RISE;
  } else if (!(config->stale_ticks >= 0)) {
    field = TL_CONFIG_STALE_TICKS;
  } else if (!(config->blind_ticks >= 0)) {
    field = TL_CONFIG_BLIND_TICKS;
  } else {
    // They can be used.
  }
  return field;
}

/// The first member of the configuration that cannot be used.
TL_INLINE int32_t tl_find_config_fault(const TlConfig* config, int32_t* index) {
  const real fastest = TL_REAL(0.5001) / config->period;
  int32_t field = TL_CONFIG_SOUND;
  *index = 0;
  if (!(tl_is_positive(config->period) && (config->period <= TL_ONE))) {
    field = TL_CONFIG_PERIOD;
  }
  if (field == TL_CONFIG_SOUND) {
    field = tl_check_joints(config, fastest, index);
  }
#if TL_TASK
  if (field == TL_CONFIG_SOUND) {
    field = tl_check_task(config, fastest, index);
  }
#endif
#if TL_BEHAVES
  if (field == TL_CONFIG_SOUND) {
    field = tl_check_behaviours(config, index);
  }
#endif
#if TL_FORCE
  if (field == TL_CONFIG_SOUND) {
    field = tl_check_force(config, fastest, index);
  }
#endif
  if (field == TL_CONFIG_SOUND) {
    field = tl_check_compliance(config, fastest, index);
  }
  if (field == TL_CONFIG_SOUND) {
    field = tl_check_safety(config, fastest, index);
  }
  return field;
}
