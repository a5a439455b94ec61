#pragma once
// Impulses at several simultaneous contacts with restitution and friction: a bounded
// number of steps, no heap.
//
// Exact impulses of one contact after the other, a few sweeps, tell which contacts
// part, stick and slide. Newton's method on all contacts at once then finds the
// impulses. Where it comes no nearer, sweeps and steps alternate; where that does not
// end, an interior-point method starts from several points. What ends is the miss of
// each law after the velocities have been computed anew.

#include "contact_interior.h"

/// What became of contacts.
struct TlContactResult {
  bool converged;
  int32_t steps;
  real miss;  // the largest of all laws, a speed
  real restitution;  // the share of each restitution that energy left
};
typedef struct TlContactResult TlContactResult;

TL_INLINE bool tl_is_number(real x) {
  return (x - x) == TL_ZERO;
}

/// Whether laws and numbers have a meaning. Friction may be infinite.
TL_FUNCTION bool tl_is_sound(
    int32_t count, const real* A, const TlContactLaw* laws, const real* v) {
  bool sound = true;
  for (int32_t i = 0; i < (9 * count * count); ++i) {
    sound = sound && tl_is_number(A[i]);
  }
  for (int32_t c = 0; c < count; ++c) {
    for (int32_t i = 0; i < 3; ++i) {
      sound =
          sound && tl_is_number(laws[c].normal[i]) && tl_is_number(v[(3 * c) + i]);
    }
    sound =
        sound && tl_is_number(laws[c].restitution) && (laws[c].friction >= TL_ZERO);
  }
  return sound;
}

/// Energy that impulses give, y . (v before + v after) / 2: a linear and a square
/// part.
TL_FUNCTION real tl_find_work(const TlContacts* all, real* linear, real* square) {
  *linear = TL_ZERO;
  *square = TL_ZERO;
  for (int32_t i = 0; i < (3 * all->count); ++i) {
    *linear += all->y[i] * all->before[i];
    *square += all->y[i] * (all->u[i] - all->free[i]);
  }
  return *linear + (TL_HALF * *square);
}

/// Shortens impulses so that they give no energy.
TL_FUNCTION void tl_take_no_energy(TlContacts* all) {
  real linear = TL_ZERO;
  real square = TL_ZERO;
  if (tl_find_work(all, &linear, &square) > TL_ZERO) {
    const real share = (linear < TL_ZERO) ? (-TL_TWO * linear / square) : TL_ZERO;
    for (int32_t i = 0; i < (3 * all->count); ++i) {
      all->y[i] *= share;
    }
    tl_find_velocities(all);
  }
}

/// Solves with a share of the restitution; whether the laws hold.
TL_FUNCTION bool tl_solve_with(TlContacts* all, real share) {
  tl_want_speeds(all, share);
  all->best_miss = TL_ONE / TL_ROUNDING;
  tl_find_velocities(all);
  if (!(all->speed > TL_ZERO)) {
    for (int32_t i = 0; i < (3 * all->count); ++i) {
      all->y[i] = TL_ZERO;
    }
    all->best_miss = TL_ZERO;
    return true;
  }
  bool met = tl_alternate(all, 4, 10);
  for (int32_t start = 0; (start < 12) && !met; ++start) {
    met = tl_go_inside(all, start) || tl_alternate(all, 2, 10);
  }
  if (!met) {
    for (int32_t i = 0; i < (3 * all->count); ++i) {
      all->y[i] = all->best[i];
    }
    tl_find_velocities(all);
  }
  return met;
}

/// Solves with as much of the restitution as energy leaves: with friction the whole
/// may make energy.
TL_FUNCTION void tl_solve_without_gain(
    TlContacts* all, bool bounces, TlContactResult* result) {
  for (int32_t turn = 0; turn < 5; ++turn) {
    real linear = TL_ZERO;
    real square = TL_ZERO;
    result->converged = tl_solve_with(all, result->restitution);
    const real work = tl_find_work(all, &linear, &square);
    const real rounding = TL_TEN * TL_TEN * all->tolerance * tl_magnitude(linear);
    const bool plastic = !bounces || (result->restitution == TL_ZERO);
    if (plastic || (result->converged && (work <= rounding))) {
      break;
    }
    result->restitution =
        (result->converged && (turn < 3)) ? (TL_HALF * result->restitution) : TL_ZERO;
  }
  tl_take_no_energy(all);
}

/// Impulses from world axes to those of the contacts; what is no number becomes 0.
TL_FUNCTION void tl_take_impulses(TlContacts* all, const real* y) {
  for (int32_t c = 0; c < all->count; ++c) {
    for (int32_t i = 0; i < 3; ++i) {
      const real start = tl_product(&all->axes[(9 * c) + (3 * i)], &y[3 * c]);
      all->y[(3 * c) + i] = tl_is_number(start) ? (start / all->scales[c]) : TL_ZERO;
    }
  }
}

/// Impulses in world axes, and the velocities that they leave.
TL_FUNCTION void tl_leave_contacts(
    const TlContacts* all, const real* A, real* v, real* y) {
  const int32_t size = 3 * all->count;
  for (int32_t c = 0; c < all->count; ++c) {
    for (int32_t i = 0; i < 3; ++i) {
      y[(3 * c) + i] = TL_ZERO;
      for (int32_t k = 0; k < 3; ++k) {
        y[(3 * c) + i] +=
            all->scales[c] * all->axes[(9 * c) + (3 * k) + i] * all->y[(3 * c) + k];
      }
    }
  }
  for (int32_t row = 0; row < size; ++row) {
    for (int32_t i = 0; i < size; ++i) {
      v[row] += A[(row * size) + i] * y[i];
    }
  }
}

/// Impulses y at `count` contacts and the velocities after them, v += A y, world
/// axes, three entries for each contact. A is the inverse inertia in contact space,
/// 3k x 3k row-major, symmetric and semidefinite; v holds the velocities before, y
/// the start.
TL_FUNCTION TlContactResult tl_solve_contacts(TlContacts* all, int32_t count,
    const real* A, const TlContactLaw* laws, real* v, real* y) {
  TlContactResult result = {false, 0, TL_ZERO, TL_ONE};
  all->count = count;
  all->steps = 0;
  all->tolerance =
      (count > TL_FEW_CONTACTS) ? TL_TOLERANCE_OF_MANY : TL_CONTACT_TOLERANCE;
  if (!tl_is_sound(count, A, laws, v)) {
    for (int32_t i = 0; i < (3 * count); ++i) {
      y[i] = TL_ZERO;
    }
    return result;
  }
  tl_enter_contacts(all, A, laws, v);
  tl_take_impulses(all, y);
  bool bounces = false;
  for (int32_t c = 0; c < count; ++c) {
    bounces = bounces || (laws[c].restitution != TL_ZERO);
  }
  tl_solve_without_gain(all, bounces, &result);
  result.steps = all->steps;
  result.miss = all->best_miss;
  tl_leave_contacts(all, A, v, y);
  return result;
}
