#pragma once
// Contacts by an interior-point method, for those that sweeps and Newton's method do
// not end. With x = (friction y_n, y_t) and z = (u_n / friction + |u_t|, u_t), the
// change of variables of De Saxce & Feng (1998), Coulomb's law is: x and z lie in the
// cone of second order, and x . z = 0. Steps by the scaling of Nesterov & Todd, a
// predictor and a corrector on one matrix; |u_t| takes part with its derivative, and
// without where its kink keeps steps short.

#include "contact_newton.h"

/// Impulses and velocities within cones, and what a step takes.
struct TlInside {
  real x[TL_CONTACT_ROWS];
  real z[TL_CONTACT_ROWS];
  real residuals[TL_CONTACT_ROWS];  // z less what u says
  real right[TL_CONTACT_ROWS];
  real change[TL_CONTACT_ROWS];  // of z
  real scaled[TL_CONTACT_ROWS];  // x and z as the scaling makes them equal
  real scaling[TL_CONTACTS * 9];  // takes x there
  real determinants[TL_CONTACTS];  // of what is scaled
  real slopes[TL_CONTACTS * 2];  // derivative of |u_t|
  real sliding[TL_CONTACTS];  // |u_t|, or what follows it
  int32_t following;  // for so many steps |u_t| has no derivative
  real gap;  // mean of x . z
  real miss;
};
typedef struct TlInside TlInside;

/// x0^2 - |x_t|^2
TL_INLINE real tl_determinant(const real* x) {
  const real length = tl_square_root((x[1] * x[1]) + (x[2] * x[2]));
  return (x[0] - length) * (x[0] + length);
}

/// The largest share of `change` after which x is within its cone; at most `most`.
TL_INLINE real tl_share_within(const real* x, const real* change, real most) {
  const real a =
      (change[0] * change[0]) - (change[1] * change[1]) - (change[2] * change[2]);
  const real b = (x[0] * change[0]) - (x[1] * change[1]) - (x[2] * change[2]);
  const real c = tl_determinant(x);
  const real inner = (b * b) - (a * c);
  real share = ((change[0] * most) < -x[0]) ? (-x[0] / change[0]) : most;
  if (inner >= TL_ZERO) {
    const real root = tl_square_root(inner);
    const real q = -(b + ((b < TL_ZERO) ? -root : root));
    const real one = (a != TL_ZERO) ? (q / a) : -TL_ONE;
    const real other = (q != TL_ZERO) ? (c / q) : -TL_ONE;
    share = ((one > TL_ZERO) && (one < share)) ? one : share;
    share = ((other > TL_ZERO) && (other < share)) ? other : share;
  }
  return share;
}

/// A factor between 0.1 and 10 that differs by contact and start; 1 in the first.
TL_INLINE real tl_spread(int32_t c, int32_t start) {
  const int32_t drawn = (((c + 1) * 7919) + (start * 104729)) % 1009;
  real stretch = TL_ONE;
  for (int32_t k = 0; (start > 0) && (k < (drawn % 21)); ++k) {
    stretch *= (TL_TEN + TL_TWO + TL_HALF) / TL_TEN;
  }
  return (start > 0) ? (stretch / TL_TEN) : TL_ONE;
}

/// The point from which a start goes. Starts differ in the sizes of x and z.
TL_FUNCTION void tl_begin_inside(const TlContacts* all, int32_t start, TlInside* in) {
  real speed = TL_ZERO;
  for (int32_t i = 0; i < (3 * all->count); ++i) {
    speed = tl_larger(speed, tl_magnitude(all->free[i]));
  }
  const real impulse = ((start % 3) == 1) ? (TL_TEN * speed) : speed;
  for (int32_t c = 0; c < all->count; ++c) {
    const real stretch = tl_spread(c, start);
    in->x[3 * c] = impulse * stretch;
    in->z[3 * c] = speed / stretch;
    for (int32_t i = 1; i < 3; ++i) {
      in->x[(3 * c) + i] = TL_ZERO;
      in->z[(3 * c) + i] = TL_ZERO;
    }
  }
  in->following = 0;
}

/// y and u of x, and by how much z misses u.
TL_FUNCTION void tl_measure_inside(TlContacts* all, TlInside* in) {
  for (int32_t c = 0; c < all->count; ++c) {
    const real friction = all->friction[c];
    const real* const x = &in->x[3 * c];
    all->y[3 * c] = (friction > TL_ZERO) ? (x[0] / friction) : x[0];
    all->y[(3 * c) + 1] = x[1];
    all->y[(3 * c) + 2] = x[2];
  }
  tl_find_velocities(all);
  real number = TL_ZERO;
  in->gap = TL_ZERO;
  in->miss = TL_ZERO;
  for (int32_t c = 0; c < all->count; ++c) {
    const real friction = all->friction[c];
    const real* const u = &all->u[3 * c];
    const real* const z = &in->z[3 * c];
    real* const left = &in->residuals[3 * c];
    const bool slides = friction > TL_ZERO;
    const real length = tl_square_root((u[1] * u[1]) + (u[2] * u[2]));
    const bool follows = in->following > 0;
    in->sliding[c] = follows ? (TL_HALF * (in->sliding[c] + length)) : length;
    left[0] = z[0] - (slides ? ((u[0] / friction) + in->sliding[c]) : u[0]);
    for (int32_t i = 1; i < 3; ++i) {
      const bool smooth = !follows && (length > TL_ZERO);
      in->slopes[(2 * c) + i - 1] = smooth ? (u[i] / length) : TL_ZERO;
      left[i] = slides ? (z[i] - u[i]) : TL_ZERO;
    }
    for (int32_t i = 0; i < 3; ++i) {
      in->miss = tl_larger(in->miss, tl_magnitude(left[i]) / all->scales[c]);
    }
    in->gap += tl_product(&in->x[3 * c], z);
    number += TL_ONE;
  }
  in->gap /= number;
}

/// The scaling of one contact: symmetric, takes x to where its inverse takes z.
TL_FUNCTION void tl_scale_contact(int32_t c, TlInside* in) {
  const real* const x = &in->x[3 * c];
  const real* const z = &in->z[3 * c];
  real* const W = &in->scaling[9 * c];
  const real size_x = tl_square_root(tl_determinant(x));
  const real size_z = tl_square_root(tl_determinant(z));
  const real angle = tl_product(x, z) / (size_x * size_z);
  const real twice = TL_TWO * tl_square_root((TL_ONE + angle) * TL_HALF);
  const real w0 = ((x[0] / size_x) + (z[0] / size_z)) / twice;
  const real w1 = ((x[1] / size_x) - (z[1] / size_z)) / twice;
  const real w2 = ((x[2] / size_x) - (z[2] / size_z)) / twice;
  const real eta = tl_square_root(size_x / size_z);
  const real share = TL_ONE / (TL_ONE + w0);
  W[0] = w0 / eta;
  W[1] = -w1 / eta;
  W[2] = -w2 / eta;
  W[3] = W[1];
  W[4] = (TL_ONE + (w1 * w1 * share)) / eta;
  W[5] = (w1 * w2 * share) / eta;
  W[6] = W[2];
  W[7] = W[5];
  W[8] = (TL_ONE + (w2 * w2 * share)) / eta;
  for (int32_t i = 0; i < 3; ++i) {
    in->scaled[(3 * c) + i] = tl_product(&W[3 * i], x);
  }
  in->determinants[c] = size_x * size_z;
}

/// Rows of one contact in the matrix of a step in x.
TL_INLINE void tl_fill_contact(TlContacts* all, int32_t c, const TlInside* in) {
  real* const rows = &all->factors[3 * c * TL_CONTACT_ROWS];
  const real friction = all->friction[c];
  const bool slides = friction > TL_ZERO;
  for (int32_t i = 0; i < tl_rows_in_eights(all); ++i) {
    const real along = rows[i];
    const real one = rows[TL_CONTACT_ROWS + i];
    const real two = rows[(2 * TL_CONTACT_ROWS) + i];
    rows[i] = slides ? ((along / friction) + (in->slopes[2 * c] * one) +
                           (in->slopes[(2 * c) + 1] * two))
                     : along;
    rows[TL_CONTACT_ROWS + i] = slides ? one : TL_ZERO;
    rows[(2 * TL_CONTACT_ROWS) + i] = slides ? two : TL_ZERO;
  }
  const real* const W = &in->scaling[9 * c];
  for (int32_t i = 0; i < 3; ++i) {
    real* const own = &rows[(i * TL_CONTACT_ROWS) + (3 * c)];
    if (slides) {
      for (int32_t j = 0; j < 3; ++j) {
        own[j] += tl_product(&W[3 * i], &W[3 * j]);
      }
    } else {
      own[i] = (i == 0) ? (own[0] + (in->z[3 * c] / in->x[3 * c])) : TL_ONE;
    }
  }
}

/// The matrix of a step, factored. False where a number has left its cone.
TL_FUNCTION bool tl_factor_inside(TlContacts* all, TlInside* in) {
  const int32_t size = 3 * all->count;
  for (int32_t row = 0; row < size; ++row) {
    for (int32_t i = 0; i < tl_rows_in_eights(all); ++i) {
      const int32_t c = i / 3;
      const bool along = ((i % 3) == 0) && (c < all->count);
      const bool scaled = along && (all->friction[c] > TL_ZERO);
      const real entry = all->G[(row * TL_CONTACT_ROWS) + i];
      all->factors[(row * TL_CONTACT_ROWS) + i] =
          scaled ? (entry / all->friction[c]) : entry;
    }
  }
  for (int32_t c = 0; c < all->count; ++c) {
    if (!(in->x[3 * c] > TL_ZERO) || !(in->z[3 * c] > TL_ZERO)) {
      return false;
    }
    if (all->friction[c] > TL_ZERO) {
      if (!(tl_determinant(&in->x[3 * c]) > TL_ZERO) ||
          !(tl_determinant(&in->z[3 * c]) > TL_ZERO)) {
        return false;
      }
      tl_scale_contact(c, in);
    }
    tl_fill_contact(all, c, in);
  }
  return tl_factor(all, size);
}

/// The right side of the step to where x . z is `wanted` at each contact.
TL_FUNCTION void tl_aim_inside(TlContacts* all, real wanted, TlInside* in) {
  for (int32_t c = 0; c < all->count; ++c) {
    const real* const at = &in->scaled[3 * c];
    real* const right = &in->right[3 * c];
    const bool slides = all->friction[c] > TL_ZERO;
    const real first = slides ? (at[0] * wanted / in->determinants[c]) : TL_ZERO;
    right[0] = slides ? (first - at[0]) : TL_ZERO;
    right[1] = slides ? (-((first / at[0]) * at[1]) - at[1]) : TL_ZERO;
    right[2] = slides ? (-((first / at[0]) * at[2]) - at[2]) : TL_ZERO;
    for (int32_t i = 0; i < 3; ++i) {
      const real* const W = &in->scaling[(9 * c) + (3 * i)];
      const real along =
          (i == 0) ? ((wanted / in->x[3 * c]) - in->z[3 * c]) : TL_ZERO;
      all->step[(3 * c) + i] =
          (slides ? tl_product(W, right) : along) + in->residuals[(3 * c) + i];
    }
  }
}

/// The step to where x . z is `wanted` at each contact; returns the share of it that
/// stays within the cones, 0 where there is none.
TL_FUNCTION real tl_step_inside(TlContacts* all, real wanted, TlInside* in) {
  tl_aim_inside(all, wanted, in);
  if (!tl_solve_factors(all, 3 * all->count)) {
    return TL_ZERO;
  }
  real share = TL_TWO;
  for (int32_t c = 0; c < all->count; ++c) {
    const real* const step = &all->step[3 * c];
    const real* const W = &in->scaling[9 * c];
    real* const change = &in->change[3 * c];
    if (all->friction[c] > TL_ZERO) {
      real moved[3];
      for (int32_t i = 0; i < 3; ++i) {
        moved[i] = in->right[(3 * c) + i] - tl_product(&W[3 * i], step);
      }
      for (int32_t i = 0; i < 3; ++i) {
        change[i] = tl_product(&W[3 * i], &moved[0]);
      }
    } else {
      change[0] = ((wanted - (in->z[3 * c] * step[0])) / in->x[3 * c]) - in->z[3 * c];
      change[1] = TL_ZERO;
      change[2] = TL_ZERO;
    }
    share = tl_share_within(&in->x[3 * c], step, share);
    share = tl_share_within(&in->z[3 * c], change, share);
  }
  return share;
}

/// Newton steps from a point inside, as long as each comes nearer.
TL_FUNCTION bool tl_finish(TlContacts* all) {
  real miss = tl_find_miss(all);
  const real hundred = TL_TEN * TL_TEN;
  for (int32_t turn = 0; turn < 6; ++turn) {
    const real least = tl_larger(TL_CONTACT_SHIFT, miss / (hundred * all->speed));
    if (!tl_newton_step(
            all, (least < (TL_ONE / hundred)) ? least : (TL_ONE / hundred))) {
      return false;
    }
    const real next = tl_find_miss(all);
    if (tl_is_met(all, next)) {
      return true;
    }
    if (!(next < (TL_TEN * miss))) {
      return false;
    }
    miss = next;
  }
  return false;
}

/// One step from inside to inside, by predictor and corrector; returns the share of
/// it that was made, 0 where there is no step.
TL_FUNCTION real tl_advance_inside(TlContacts* all, TlInside* in) {
  const real hundredth = TL_ONE / (TL_TEN * TL_TEN);
  if (!tl_factor_inside(all, in)) {
    return TL_ZERO;
  }
  const real reach = tl_step_inside(all, TL_ZERO, in);
  const real left = TL_ONE - ((reach < TL_ONE) ? reach : TL_ONE);
  const real kept = tl_larger(left * left * left, TL_HALF / TL_TEN);
  const real most = tl_step_inside(all, kept * in->gap, in) * (TL_ONE - hundredth);
  const real share = (most < TL_ONE) ? most : TL_ONE;
  for (int32_t i = 0; i < (3 * all->count); ++i) {
    in->x[i] += share * all->step[i];
    in->z[i] += share * in->change[i];
  }
  return share;
}

/// The whole method from one start: whether all laws are met. Else y is where it
/// ended.
TL_FUNCTION bool tl_go_inside(TlContacts* all, int32_t start) {
  TlInside in;
  tl_begin_inside(all, start, &in);
  const real first = tl_product(&in.x[0], &in.z[0]);
  const real tenth = TL_ONE / TL_TEN;
  real near = tenth * tenth * tenth;
  int32_t short_steps = 0;
  for (int32_t turn = 0; (turn < 40) && (short_steps < 4); ++turn) {
    ++all->steps;
    tl_measure_inside(all, &in);
    if ((in.miss < (near * all->speed)) && (in.gap < (near * first))) {
      if (tl_finish(all)) {
        return true;
      }
      tl_measure_inside(all, &in);
      near *= tenth * tenth;
    }
    const bool ended = !(in.gap > (TL_ROUNDING * TL_ROUNDING * first));
    const real share = ended ? TL_ZERO : tl_advance_inside(all, &in);
    if (!(share > TL_ZERO)) {
      break;
    }
    short_steps = (share < (TL_HALF * tenth)) ? (short_steps + 1) : 0;
    const bool kinks = (share < tenth) && ((start % 2) == 0);
    in.following = (in.following > 0) ? (in.following - 1) : (kinks ? 4 : 0);
  }
  tl_measure_inside(all, &in);
  for (int32_t c = 0; c < all->count; ++c) {
    all->rates[c] = TL_ZERO;
  }
  return false;
}
