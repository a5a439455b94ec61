#pragma once
// All contacts at once: Newton's method on the equations that hold while each contact
// parts, sticks or slides as it does now.

#include "contact_sweep.h"

/// LU with partial pivoting of the first `size` rows, in place. The pivot's row is
/// copied, so that loops of eight become SIMD. False where a pivot is 0 or no number.
TL_FUNCTION bool tl_factor(TlContacts* all, int32_t size) {
  real* const A = &all->factors[0];
  const int32_t end = ((size + 7) / 8) * 8;
  for (int32_t p = 0; p < size; ++p) {
    int32_t best = p;
    for (int32_t row = p + 1; row < size; ++row) {
      const bool exceeds = tl_magnitude(A[(row * TL_CONTACT_ROWS) + p]) >
          tl_magnitude(A[(best * TL_CONTACT_ROWS) + p]);
      best = exceeds ? row : best;
    }
    all->pivots[p] = best;
    real pivot[TL_CONTACT_ROWS];
    const int32_t begin = (p / 8) * 8;
    for (int32_t i = 0; i < end; ++i) {
      pivot[i] = A[(best * TL_CONTACT_ROWS) + i];
      A[(best * TL_CONTACT_ROWS) + i] = A[(p * TL_CONTACT_ROWS) + i];
      A[(p * TL_CONTACT_ROWS) + i] = pivot[i];
    }
    if (!(tl_magnitude(pivot[p]) > TL_ZERO)) {
      return false;
    }
    const real inverse = TL_ONE / pivot[p];
    for (int32_t i = begin; i <= p; ++i) {
      pivot[i] = TL_ZERO;  // what stands before stays
    }
    for (int32_t row = p + 1; row < size; ++row) {
      real* const own = &A[row * TL_CONTACT_ROWS];
      const real factor = own[p] * inverse;
      for (int32_t i = begin; i < end; i += 8) {
        for (int32_t k = 0; k < 8; ++k) {
          own[i + k] -= factor * pivot[i + k];
        }
      }
      own[p] = factor;
    }
  }
  return true;
}

/// Solves with the factors: `step` holds the right side on entry. False where the
/// result is no number.
TL_FUNCTION bool tl_solve_factors(TlContacts* all, int32_t size) {
  const real* const A = &all->factors[0];
  real* const x = &all->step[0];
  bool finite = true;
  for (int32_t p = 0; p < size; ++p) {
    const int32_t pivot = all->pivots[p];
    const real here = x[p];
    x[p] = x[pivot];
    x[pivot] = here;
  }
  for (int32_t p = 1; p < size; ++p) {
    real sum = x[p];
    for (int32_t i = 0; i < p; ++i) {
      sum -= A[(p * TL_CONTACT_ROWS) + i] * x[i];
    }
    x[p] = sum;
  }
  for (int32_t p = size - 1; p >= 0; --p) {
    real sum = x[p];
    for (int32_t i = p + 1; i < size; ++i) {
      sum -= A[(p * TL_CONTACT_ROWS) + i] * x[i];
    }
    x[p] = sum / A[(p * TL_CONTACT_ROWS) + p];
    finite = finite && ((x[p] - x[p]) == TL_ZERO);
  }
  return finite;
}

/// Unknowns of Newton's method: one column of impulses and one row of velocities
/// each. A contact that sticks has three, one that slides two: along the edge of its
/// cone, and across the slide.
struct TlUnknowns {
  real columns[TL_CONTACT_ROWS * 3];
  real rows[TL_CONTACT_ROWS * 3];
  int32_t contacts[TL_CONTACT_ROWS];
  int32_t count;
};
typedef struct TlUnknowns TlUnknowns;

TL_INLINE void tl_add_unknown(TlContacts* all, int32_t c, const real* column,
    const real* row, real added, TlUnknowns* unknowns) {
  const int32_t at = unknowns->count;
  for (int32_t i = 0; i < 3; ++i) {
    unknowns->columns[(3 * at) + i] = column[i];
    unknowns->rows[(3 * at) + i] = row[i];
  }
  unknowns->contacts[at] = c;
  all->step[at] = -tl_product(row, &all->u[3 * c]);
  all->factors[(at * TL_CONTACT_ROWS) + at] = added;
  unknowns->count = at + 1;
}

/// Unknowns of a contact that slides: u_n = 0, and u_t against y_t. Turning y_t turns
/// u_t's share across it, by |u_t| / |y_t|.
TL_INLINE void tl_add_slide(
    TlContacts* all, int32_t c, real shift, TlUnknowns* unknowns) {
  const real* const y = &all->y[3 * c];
  const real* const u = &all->u[3 * c];
  const real friction = all->friction[c];
  const real length = tl_square_root((y[1] * y[1]) + (y[2] * y[2]));
  const real d1 = (length > TL_ZERO) ? (y[1] / length) : TL_ONE;
  const real d2 = (length > TL_ZERO) ? (y[2] / length) : TL_ZERO;
  // By assignments: some compilers call memset for lists with constants.
  real edge[3];
  real normal[3];
  real aside[3];
  edge[0] = TL_ONE;
  edge[1] = friction * d1;
  edge[2] = friction * d2;
  normal[0] = TL_ONE;
  normal[1] = TL_ZERO;
  normal[2] = TL_ZERO;
  aside[0] = TL_ZERO;
  aside[1] = -d2;
  aside[2] = d1;
  tl_add_unknown(all, c, &edge[0], &normal[0], shift, unknowns);
  if (friction > TL_ZERO) {
    const real against = tl_larger(-((d1 * u[1]) + (d2 * u[2])), TL_ZERO);
    const real rate = (length > TL_ZERO) ? (against / length) : TL_ZERO;
    tl_add_unknown(all, c, &aside[0], &aside[0], rate + shift, unknowns);
  }
}

/// The matrix rows^T G columns, beside what was added to its diagonal.
TL_FUNCTION void tl_fill_matrix(TlContacts* all, const TlUnknowns* unknowns) {
  const int32_t size = tl_rows_in_eights(all);
  for (int32_t at = 0; at < unknowns->count; ++at) {
    real row[TL_CONTACT_ROWS];
    for (int32_t i = 0; i < size; ++i) {
      row[i] = TL_ZERO;
    }
    const int32_t c = unknowns->contacts[at];
    tl_add_three_rows(
        &unknowns->rows[3 * at], &all->G[3 * c * TL_CONTACT_ROWS], size, &row[0]);
    real* const entries = &all->factors[at * TL_CONTACT_ROWS];
    const real added = entries[at];
    for (int32_t i = 0; i < unknowns->count; ++i) {
      entries[i] =
          tl_product(&unknowns->columns[3 * i], &row[3 * unknowns->contacts[i]]);
    }
    entries[at] += added;
    for (int32_t i = unknowns->count; i < (((unknowns->count + 7) / 8) * 8); ++i) {
      entries[i] = TL_ZERO;
    }
  }
}

/// Takes an impulse into its cone: none that pulls, and none across beyond friction;
/// with `edge` as much across as friction permits.
TL_INLINE void tl_take_into_cone(real friction, bool edge, real* y) {
  const real length = tl_square_root((y[1] * y[1]) + (y[2] * y[2]));
  const real most = friction * tl_larger(y[0], TL_ZERO);
  y[0] = tl_larger(y[0], TL_ZERO);
  if ((length > most) || (edge && (length > TL_ZERO))) {
    y[1] *= most / length;
    y[2] *= most / length;
  }
}

/// One step of Newton's method; `shift` is added to the diagonal, where contacts
/// depend on each other. False where there is no step.
TL_FUNCTION bool tl_newton_step(TlContacts* all, real shift) {
  TlUnknowns unknowns;
  unknowns.count = 0;
  for (int32_t c = 0; c < all->count; ++c) {
    if (all->states[c] == TL_SLIDES) {
      tl_add_slide(all, c, shift, &unknowns);
    } else if (all->states[c] == TL_STICKS) {
      for (int32_t i = 0; i < 3; ++i) {
        const real unit[3] = {(i == 0) ? TL_ONE : TL_ZERO,
            (i == 1) ? TL_ONE : TL_ZERO, (i == 2) ? TL_ONE : TL_ZERO};
        tl_add_unknown(all, c, &unit[0], &unit[0], shift, &unknowns);
      }
    } else {
      all->y[3 * c] = TL_ZERO;
      all->y[(3 * c) + 1] = TL_ZERO;
      all->y[(3 * c) + 2] = TL_ZERO;
    }
  }
  ++all->steps;
  tl_fill_matrix(all, &unknowns);
  if (!tl_factor(all, unknowns.count) || !tl_solve_factors(all, unknowns.count)) {
    return false;
  }
  for (int32_t at = 0; at < unknowns.count; ++at) {
    for (int32_t i = 0; i < 3; ++i) {
      all->y[(3 * unknowns.contacts[at]) + i] +=
          all->step[at] * unknowns.columns[(3 * at) + i];
    }
  }
  for (int32_t c = 0; c < all->count; ++c) {
    tl_take_into_cone(all->friction[c], all->states[c] == TL_SLIDES, &all->y[3 * c]);
  }
  tl_find_velocities(all);
  return true;
}

/// Newton steps and, where one comes no nearer, sweeps and a larger shift: at most
/// `most` times, after `sweeps` sweeps. Whether all laws are met.
TL_FUNCTION bool tl_alternate(TlContacts* all, int32_t sweeps, int32_t most) {
  for (int32_t i = 0; i < sweeps; ++i) {
    tl_sweep(all, (i % 2) == 1);
  }
  tl_find_velocities(all);
  real miss = tl_find_miss(all);
  int32_t burst = 1;
  real growth = TL_ONE;
  const real hundred = TL_TEN * TL_TEN;
  for (int32_t turn = 0; (turn < most) && !tl_is_met(all, miss); ++turn) {
    real kept[TL_CONTACT_ROWS];
    for (int32_t i = 0; i < (3 * all->count); ++i) {
      kept[i] = all->y[i];
    }
    const real shift =
        tl_larger(TL_CONTACT_SHIFT, miss / (hundred * hundred * all->speed));
    const bool stepped =
        tl_newton_step(all, ((growth * shift) < TL_ONE) ? (growth * shift) : TL_ONE);
    const real next = stepped ? tl_find_miss(all) : (TL_ONE / TL_ROUNDING);
    if (tl_is_met(all, next) || (next < (TL_HALF * miss))) {
      miss = next;
      burst = 1;
      growth = (growth > TL_ONE) ? (growth / TL_TEN) : TL_ONE;
      continue;
    }
    if (!(next < (TL_TWO * TL_TWO * miss))) {
      for (int32_t i = 0; i < (3 * all->count); ++i) {
        all->y[i] = kept[i];
      }
      tl_find_velocities(all);
    }
    growth *= TL_TEN;
    for (int32_t i = 0; i < burst; ++i) {
      tl_sweep(all, (i % 2) == 1);
    }
    burst = (burst < 8) ? (2 * burst) : burst;
    tl_find_velocities(all);
    miss = tl_find_miss(all);
  }
  return tl_is_met(all, miss);
}
