#pragma once
// How far references may be left behind, and how they wait for what stays behind.

#include "controller_numbers.h"

/// How far something may be from a reference that set out `time` seconds ago on a
/// motion of 1 / `rate` seconds: `following`, and half of that once the reference has
/// stood for a second.
TL_INLINE real tl_admitted_error(const TlConfig* config, real time, real rate) {
  const bool stands = ((time - TL_ONE) * rate) > TL_ONE;
  return stands ? (TL_REAL(0.5) * config->following) : config->following;
}

/// The share by which a reference is to go slower that is left by `away`: it slows
/// down from a twentieth of `following` on, and stands at 0.3 of it.
TL_INLINE real tl_behind(const TlConfig* config, real away) {
  return (TL_REAL(4.0) * away / config->following) - TL_REAL(0.2);
}

/// The share by which a reference goes slower in the next step, now by `slow`, where
/// `asked` is asked for. It changes smoothly: within `speed_rise`, at most 0.15 s, to
/// a stand, and within twice that back.
TL_INLINE real tl_slow_down(const TlConfig* config, real asked, real slow) {
  const real least = (asked > TL_ZERO) ? asked : TL_ZERO;
  const real wanted = (asked < TL_ONE) ? least : TL_ONE;
  const real soon = tl_smaller(config->speed_rise, TL_REAL(0.15));
  const real rise = tl_larger(soon, config->period);
  const real follows = tl_smaller(TL_REAL(5.0) * config->period / rise, TL_ONE);
  const real change = wanted - slow;
  const real rate =
      config->period / ((change > TL_ZERO) ? rise : (TL_REAL(2.0) * rise));
  return slow + tl_within(follows * change, rate);
}

/// Whether a reference that goes slower by `slow` waits.
TL_INLINE bool tl_is_waiting(real slow) {
  return slow > TL_REAL(0.9);
}

/// Whether references have waited for half a second, `ticks` steps: nothing leads on.
TL_INLINE bool tl_has_waited(const TlConfig* config, int32_t ticks) {
  return tl_seconds(ticks, config->period) > TL_REAL(0.5);
}
