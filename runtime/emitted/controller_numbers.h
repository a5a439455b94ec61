#pragma once
// Numbers of a controller: which are finite, bounds, whole turns, counted steps.

#include <stdbool.h>
#include <stdint.h>

/// False for NaN and infinities.
TL_INLINE bool tl_is_number(real x) {
  return (x - x) == TL_ZERO;
}

TL_INLINE bool tl_are_numbers(const real* x, int32_t count) {
  bool all = true;
  for (int32_t i = 0; i < count; ++i) {
    all = all && tl_is_number(x[i]);
  }
  return all;
}

TL_INLINE real tl_magnitude(real x) {
  return (x < TL_ZERO) ? -x : x;
}

TL_INLINE real tl_smaller(real a, real b) {
  return (a < b) ? a : b;
}

TL_INLINE real tl_larger(real a, real b) {
  return (a > b) ? a : b;
}

/// x between -most and most; 0 for NaN.
TL_INLINE real tl_within(real x, real most) {
  return (x > most) ? most : ((x < -most) ? -most : ((x == x) ? x : TL_ZERO));
}

/// x less its whole turns, between -pi and pi where |x| is below a million turns.
TL_INLINE real tl_shortest_turn(real x) {
  const real turns = x * TL_REAL(0.15915494309189535);
  real turned = x;
  if (tl_magnitude(turns) < TL_REAL(1000000.0)) {
    const real nearest = turns + ((turns < TL_ZERO) ? TL_REAL(-0.5) : TL_REAL(0.5));
    const int32_t whole = TL_AS_INDEX(nearest);
    turned = x - (TL_AS_REAL(whole) * TL_REAL(6.283185307179586));
  }
  return turned;
}

TL_INLINE real tl_seconds(int32_t ticks, real period) {
  return TL_AS_REAL(ticks) * period;
}

/// A counter of steps, one further; stops where it would run over.
TL_INLINE int32_t tl_count_tick(int32_t ticks) {
  int32_t counted = ticks;
  if (ticks < 1073741823) {
    counted += 1;
  }
  return counted;
}

/// 1 or 0.
TL_INLINE int32_t tl_flag(bool is_set) {
  int32_t flag = 0;
  if (is_set) {
    flag = 1;
  }
  return flag;
}

TL_INLINE void tl_copy_numbers(const real* from, int32_t count, real* to) {
  for (int32_t i = 0; i < count; ++i) {
    to[i] = from[i];
  }
}

TL_INLINE void tl_clear_numbers(int32_t count, real* x) {
  for (int32_t i = 0; i < count; ++i) {
    x[i] = TL_ZERO;
  }
}

/// Leads numbers that describe the robot a share nearer to what they have become; at
/// once where a way so long has left numbers behind that are none. They stay what
/// they were where one of them is lost.
TL_INLINE void tl_lead_to(const real* now, int32_t count, real share, real* led) {
  const bool sound = tl_are_numbers(now, count);
  for (int32_t i = 0; i < count; ++i) {
    const real nearer = led[i] + (share * (now[i] - led[i]));
    const real next = ((share < TL_ONE) && tl_is_number(nearer)) ? nearer : now[i];
    led[i] = sound ? next : led[i];
  }
}

/// The share of a change of the robot, such as a payload, that a step takes over: 98
/// % of it are there after `fade`, so that the torque has no step. All of it in the
/// first.
TL_INLINE real tl_adopted_share(real period, real fade, bool first) {
  const real part = TL_REAL(4.0) * period;
  real share = TL_ONE;
  if ((!first) && (part < fade)) {
    share = part / fade;
  }
  return share;
}
