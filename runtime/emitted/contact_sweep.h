#pragma once
// One contact after the other: the impulse at a contact that its law asks for while
// all others stay, exactly, and sweeps over all contacts (Gauss-Seidel).

#include "contact_work.h"

/// The impulse of a contact that slides. With the normal speed 0 and u_t = -rate y_t,
/// y_t is a function of the rate, and
///
///     psi(rate) = friction y_n / |y_t| - 1
///
/// is negative where the rate is too small and positive where it is too large: Newton
/// steps within the interval that is known.
TL_FUNCTION void tl_slide(
    TlContacts* all, int32_t c, const real* u, const real* offset, real* y) {
  const real* const W = &all->G[(3 * c * TL_CONTACT_ROWS) + (3 * c)];
  const real friction = all->friction[c];
  real low = TL_ZERO;
  real high = TL_ZERO;  // 0: none is known
  real rate = (all->rates[c] > TL_ZERO) ? all->rates[c] : TL_ONE;
  for (int32_t turn = 0; turn < 8; ++turn) {
    const real d1 = TL_ONE / (all->across[2 * c] + rate);
    const real d2 = TL_ONE / (all->across[(2 * c) + 1] + rate);
    y[1] = -offset[0] * d1;
    y[2] = -offset[1] * d2;
    y[0] = -(u[0] + (W[1] * y[1]) + (W[2] * y[2])) / W[0];
    const real length = tl_square_root((y[1] * y[1]) + (y[2] * y[2]));
    const real psi = (friction * y[0] / length) - TL_ONE;
    if (tl_magnitude(psi) <= (TL_TWO * TL_ROUNDING)) {
      break;
    }
    low = (psi < TL_ZERO) ? rate : low;
    high = (psi < TL_ZERO) ? high : rate;
    const real shorter = ((y[1] * y[1] * d1) + (y[2] * y[2] * d2)) / length;
    const real along = ((W[1] * y[1] * d1) + (W[2] * y[2] * d2)) / W[0];
    const real slope =
        friction * ((along * length) + (y[0] * shorter)) / (length * length);
    real next = rate - (psi / slope);
    if (!(slope > TL_ZERO) || !(next > low) || ((high > TL_ZERO) && !(next < high))) {
      const real middle =
          (low > TL_ZERO) ? tl_square_root(low * high) : (high / TL_TEN);
      next = (high > TL_ZERO) ? middle : (TL_TEN * rate);
    }
    if (tl_magnitude(next - rate) <= (TL_ROUNDING * rate)) {
      break;
    }
    rate = next;
  }
  all->rates[c] = rate;
  const real length = tl_square_root((y[1] * y[1]) + (y[2] * y[2]));
  y[0] = tl_larger(y[0], TL_ZERO);
  const real share = (length > TL_ZERO) ? (friction * y[0] / length) : TL_ZERO;
  y[1] *= share;
  y[2] *= share;
}

/// The impulse that one contact's law asks for, where u is its velocity without it.
TL_INLINE int32_t tl_meet_law(TlContacts* all, int32_t c, const real* u, real* y) {
  const real* const W = &all->G[(3 * c * TL_CONTACT_ROWS) + (3 * c)];
  const real noise = TL_TEN * TL_TEN * TL_ROUNDING;
  y[0] = TL_ZERO;
  y[1] = TL_ZERO;
  y[2] = TL_ZERO;
  if (!(u[0] < TL_ZERO) || !(W[0] > noise)) {
    return TL_PARTS;
  }
  if (!(all->friction[c] > TL_ZERO)) {
    y[0] = -u[0] / W[0];
    return TL_SLIDES;
  }
  real offset[2];  // velocity across once the normal speed is 0
  for (int32_t i = 0; i < 2; ++i) {
    const real mobility = all->across[(2 * c) + i];
    offset[i] = u[i + 1] - (W[i + 1] * u[0] / W[0]);
    const bool still =
        tl_magnitude(offset[i]) <= (all->tolerance * all->speed * all->scales[c]);
    const real divisor = (mobility > noise) ? mobility : noise;
    y[i + 1] = (still && !(mobility > noise)) ? TL_ZERO : (-offset[i] / divisor);
  }
  y[0] = -(u[0] + (W[1] * y[1]) + (W[2] * y[2])) / W[0];
  const real most = all->friction[c] * y[0];
  if ((y[0] > TL_ZERO) && (((y[1] * y[1]) + (y[2] * y[2])) <= (most * most))) {
    return TL_STICKS;
  }
  tl_slide(all, c, u, &offset[0], y);
  return TL_SLIDES;
}

/// Lets each contact meet its law once, in one order or the other.
TL_FUNCTION void tl_sweep(TlContacts* all, bool backwards) {
  const int32_t size = tl_rows_in_eights(all);
  for (int32_t turn = 0; turn < all->count; ++turn) {
    const int32_t c = backwards ? (all->count - 1 - turn) : turn;
    const real* const W = &all->G[(3 * c * TL_CONTACT_ROWS) + (3 * c)];
    real* const y = &all->y[3 * c];
    real u[3];
    for (int32_t i = 0; i < 3; ++i) {
      u[i] = all->u[(3 * c) + i] - tl_product(&W[i * TL_CONTACT_ROWS], y);
    }
    real next[3];
    real change[3];
    all->states[c] = tl_meet_law(all, c, &u[0], &next[0]);
    for (int32_t i = 0; i < 3; ++i) {
      change[i] = next[i] - y[i];
      y[i] = next[i];
    }
    if ((change[0] != TL_ZERO) || (change[1] != TL_ZERO) || (change[2] != TL_ZERO)) {
      tl_add_three_rows(
          &change[0], &all->G[3 * c * TL_CONTACT_ROWS], size, &all->u[0]);
    }
  }
  ++all->steps;
}

/// By how much one contact misses its law, a speed times its scale, and what it does.
/// The law as projections (Alart & Curnier 1991): y_n is that of y_n - u_n on y_n >=
/// 0, y_t that of y_t - u_t on the disc |y_t| <= friction y_n.
TL_INLINE real tl_miss_of(TlContacts* all, int32_t c) {
  const real* const y = &all->y[3 * c];
  const real* const u = &all->u[3 * c];
  const real W = all->G[(3 * c * TL_CONTACT_ROWS) + (3 * c)];
  const real least = TL_ONE / (TL_TEN * TL_TEN * TL_TEN);
  const real mobility = (W > least) ? W : least;
  if (!(((y[0] * mobility) - u[0]) > TL_ZERO)) {
    all->states[c] = TL_PARTS;
    return mobility *
        tl_larger(y[0], tl_larger(tl_magnitude(y[1]), tl_magnitude(y[2])));
  }
  const real across[2] = {y[1] - u[1], y[2] - u[2]};
  const real length =
      tl_square_root((across[0] * across[0]) + (across[1] * across[1]));
  const real most = all->friction[c] * y[0];
  if (length <= most) {
    all->states[c] = TL_STICKS;
    return tl_larger(
        tl_magnitude(u[0]), tl_larger(tl_magnitude(u[1]), tl_magnitude(u[2])));
  }
  all->states[c] = TL_SLIDES;
  const real share = most / length;
  return tl_larger(tl_magnitude(u[0]),
      tl_larger(tl_magnitude(y[1] - (share * across[0])),
          tl_magnitude(y[2] - (share * across[1]))));
}

/// The largest miss of all contacts, a speed. Keeps the impulses with the least one.
TL_FUNCTION real tl_find_miss(TlContacts* all) {
  real miss = TL_ZERO;
  bool finite = true;
  for (int32_t c = 0; c < all->count; ++c) {
    const real own = tl_miss_of(all, c) / all->scales[c];
    finite = finite && ((own - own) == TL_ZERO);
    miss = tl_larger(miss, own);
  }
  if (finite && (miss < all->best_miss)) {
    all->best_miss = miss;
    for (int32_t i = 0; i < (3 * all->count); ++i) {
      all->best[i] = all->y[i];
    }
  }
  return finite ? miss : (TL_ONE / TL_ROUNDING);
}

/// Whether a miss is no more than the tolerance, or than rounding in u.
TL_FUNCTION bool tl_is_met(const TlContacts* all, real miss) {
  if (miss <= (all->tolerance * all->speed)) {
    return true;
  }
  if (miss > (TL_TEN * TL_TEN * TL_TEN * all->tolerance * all->speed)) {
    return false;
  }
  real most = TL_ZERO;
  for (int32_t row = 0; row < (3 * all->count); ++row) {
    real sum = tl_magnitude(all->free[row]);
    for (int32_t i = 0; i < (3 * all->count); ++i) {
      sum += tl_magnitude(all->G[(row * TL_CONTACT_ROWS) + i] * all->y[i]);
    }
    most = tl_larger(most, sum / all->scales[row / 3]);
  }
  return miss <= (TL_TEN * TL_ROUNDING * most);
}
