#pragma once
// The course of the method of quadratic_program.h: the row that is missed most
// enters, those whose multiplier would change its sign leave.

#include "quadratic_program.h"

/// J = 1 and the minimum without rows: the centre. `most` iterations.
TL_INLINE void tl_start_at_center(
    TlActiveSet* set, const TlRowsOfLimits* rows, int32_t most) {
  for (int32_t i = 0; i < TL_LIMIT_ROWS; ++i) {
    const real* const a = &rows->A[i * TL_UNKNOWNS];
    const real square = tl_dot(a, a);
    const real inverse = TL_ONE / ((square > TL_ZERO) ? square : TL_ONE);
    set->inverse_squares[i] = (square > TL_ZERO) ? inverse : TL_ZERO;
  }
  for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
    set->ignored[row] = false;
    set->tolerance[row] = TL_ROW_TOLERANCE;
  }
  for (int32_t k = 0; k < TL_UNKNOWNS; ++k) {
    for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
      set->Jt[(k * TL_UNKNOWNS) + i] = (i == k) ? TL_ONE : TL_ZERO;
    }
    set->x[k] = set->center[k];
  }
  set->status = TL_SOLVED;
  set->iterations = 0;
  set->left = most;
  set->count = 0;
}

/// Makes the row active if it depends on no others.
TL_INLINE void tl_start_with_row(
    TlActiveSet* set, const TlRowsOfLimits* rows, int32_t row, int32_t side) {
  const real bound =
      (side == TL_UPPER) ? tl_upper_of(rows, row) : tl_lower_of(rows, row);
  if ((side != TL_FREE) && (set->count < TL_UNKNOWNS) && tl_is_finite(bound)) {
    tl_project_normal(set, rows, row, side);
    const real apart = tl_free_part(set);
    if (!tl_depends(set, apart)) {
      tl_add_row(set, row, side, apart, TL_ZERO);
    }
  }
}

/// Makes the rows of the start active, equations first, and drops those of the wrong
/// sign. `sides` are those of the last cycle, if there was one.
TL_INLINE void tl_add_start(TlActiveSet* set, const TlRowsOfLimits* rows, bool warm) {
  int32_t first[TL_ALL_ROWS];
  for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
    const bool starts = warm && (set->sides[row] != TL_SET_ASIDE);
    const int32_t own = starts ? set->sides[row] : TL_FREE;
    first[row] = tl_is_equation(rows, row) ? TL_LOWER : own;
    set->sides[row] = TL_FREE;
  }
  for (int32_t pass = 0; pass < 2; ++pass) {
    for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
      if (tl_is_equation(rows, row) == (pass == 0)) {
        tl_start_with_row(set, rows, row, first[row]);
      }
    }
  }
  if (set->count > 0) {
    tl_settle(set, rows);
  }
}

/// The sizes of what adds up to a row's value, and a share of the centre's: x comes
/// from there by steps that cancel it, and is rounded by it.
TL_INLINE real tl_terms_of(
    const TlActiveSet* set, const TlRowsOfLimits* rows, int32_t row) {
  real terms = TL_ZERO;
  real center = TL_ZERO;
  if (row < TL_UNKNOWNS) {
    terms = tl_size_of(set->x[row]);
    center = tl_size_of(set->center[row]);
  } else {
    const real* const a = tl_row_of(rows, row);
    terms = tl_dot_of_sizes(a, &set->x[0]);
    center = tl_dot_of_sizes(a, &set->center[0]);
  }
  return terms + (TL_CENTER_SHARE * center);
}

/// Keeps the row if it is missed by more than those before, measured along its
/// normal.
TL_INLINE void tl_consider(const TlActiveSet* set, const TlRowsOfLimits* rows,
    int32_t row, TlViolation* worst, real* worst_square) {
  const bool is_bound = row < TL_UNKNOWNS;
  const real value =
      is_bound ? set->x[row] : tl_dot(tl_row_of(rows, row), &set->x[0]);
  const real below = tl_lower_of(rows, row) - value;
  const real above = value - tl_upper_of(rows, row);
  const bool is_below = below > above;
  const real amount = is_below ? below : above;
  const real square =
      amount * amount * (is_bound ? TL_ONE : set->inverse_squares[row - TL_UNKNOWNS]);
  if ((amount > TL_ZERO) && (!set->ignored[row]) && (square > *worst_square)) {
    const real bound = is_below ? tl_lower_of(rows, row) : tl_upper_of(rows, row);
    const real terms = tl_terms_of(set, rows, row) + tl_size_of(bound);
    if (amount > (set->tolerance[row] * terms)) {
      *worst_square = square;
      worst->row = row;
      worst->side = is_below ? TL_LOWER : TL_UPPER;
      worst->amount = amount;
      worst->tolerance = TL_CONTRADICTION * terms;
    }
  }
}

/// Row -1 where none is missed by more than rounding.
TL_INLINE TlViolation tl_most_violated(
    const TlActiveSet* set, const TlRowsOfLimits* rows) {
  TlViolation worst;
  worst.row = -1;
  worst.side = TL_FREE;
  worst.amount = TL_ZERO;
  worst.tolerance = TL_ZERO;
  real worst_square = TL_ZERO;
  for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
    if (set->sides[row] == TL_FREE) {
      tl_consider(set, rows, row, &worst, &worst_square);
    }
  }
  return worst;
}

/// The active row whose multiplier vanishes first, and at which step; -1 where none
/// does.
TL_INLINE int32_t tl_first_to_leave(
    const TlActiveSet* set, const TlRowsOfLimits* rows, real* step) {
  int32_t first = -1;
  for (int32_t j = 0; j < set->count; ++j) {
    if ((set->r[j] > TL_ZERO) && (!tl_is_equation(rows, set->active[j]))) {
      const real own = set->u[j] / set->r[j];
      if ((first < 0) || (own < *step)) {
        first = j;
        *step = own;
      }
    }
  }
  return first;
}

/// A row that depends on active ones which cannot leave: it contradicts them, or
/// holds but for rounding.
TL_INLINE void tl_leave_out(
    TlActiveSet* set, const TlRowsOfLimits* rows, const TlViolation* violation) {
  if (violation->amount > violation->tolerance) {
    set->sides[violation->row] = TL_SET_ASIDE;
    set->status = TL_CONFLICTING;
  } else {
    set->ignored[violation->row] = true;
  }
  tl_settle(set, rows);
}

/// x and the multipliers a step along the row's normal.
TL_INLINE void tl_move(TlActiveSet* set, real step, bool dependent) {
  if (!dependent) {
    real along[TL_UNKNOWNS];
    for (int32_t k = 0; k < TL_UNKNOWNS; ++k) {
      along[k] = step * set->d[k];
    }
    tl_add_rows(&along[0], &set->Jt[0], set->count, TL_UNKNOWNS, &set->x[0]);
  }
  for (int32_t j = 0; j < set->count; ++j) {
    set->u[j] -= step * set->r[j];
  }
}

/// One step towards making the row active. False when it is active, or left out.
TL_INLINE bool tl_take_step(TlActiveSet* set, const TlRowsOfLimits* rows,
    const TlViolation* violation, real* missing, real* multiplier) {
  const real apart = tl_free_part(set);
  const bool dependent = tl_depends(set, apart);
  for (int32_t i = 0; i < set->count; ++i) {
    set->r[i] = set->d[i];
  }
  tl_solve_back(set);
  real step = TL_ZERO;
  const int32_t leaving = tl_first_to_leave(set, rows, &step);
  bool goes_on = false;
  if (dependent && (leaving < 0)) {
    tl_leave_out(set, rows, violation);
  } else {
    const real full = dependent ? TL_ZERO : (*missing / (apart * apart));
    goes_on = dependent || ((leaving >= 0) && (step < full));
    if (!goes_on) {
      step = full;
    }
    tl_move(set, step, dependent);
    *multiplier += step;
    if (goes_on) {
      if (!dependent) {
        *missing -= step * apart * apart;
      }
      tl_drop_row(set, leaving);
    } else {
      tl_add_row(set, violation->row, violation->side, apart, *multiplier);
    }
  }
  return goes_on;
}

TL_INLINE void tl_enter(
    TlActiveSet* set, const TlRowsOfLimits* rows, const TlViolation* violation) {
  tl_project_normal(set, rows, violation->row, violation->side);
  real missing = violation->amount;
  real multiplier = TL_ZERO;
  bool goes_on = true;
  while (goes_on) {
    if (set->left == 0) {
      tl_settle(set, rows);
      goes_on = false;
    } else {
      --set->left;
      ++set->iterations;
      goes_on = tl_take_step(set, rows, violation, &missing, &multiplier);
    }
  }
}

/// Whether x is on a side of both bounds: of NaN it is on none, which nothing else
/// notices.
TL_INLINE bool tl_is_comparable(
    const TlActiveSet* set, const TlRowsOfLimits* rows, int32_t row) {
  const real value =
      (row < TL_UNKNOWNS) ? set->x[row] : tl_dot(tl_row_of(rows, row), &set->x[0]);
  const real lower = tl_lower_of(rows, row);
  const real upper = tl_upper_of(rows, row);
  const bool under = value < lower;
  const bool from_lower = value >= lower;
  const bool over = value > upper;
  const bool up_to_upper = value <= upper;
  return (under || from_lower) && (over || up_to_upper);
}

/// Zero where numbers do not fit.
TL_INLINE void tl_finish(TlActiveSet* set, const TlRowsOfLimits* rows) {
  if (set->status == TL_LIMIT) {
    tl_settle(set, rows);
  }
  tl_correct(set, rows);
  bool finite = true;
  for (int32_t j = 0; j < set->count; ++j) {
    finite = finite && tl_is_finite(set->u[j]);
  }
  for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
    finite = finite && tl_is_finite(set->x[i]);
  }
  for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
    finite = finite && tl_is_comparable(set, rows, row);
  }
  if (!finite) {
    for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
      set->x[i] = TL_ZERO;
    }
    for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
      set->sides[row] = TL_FREE;
    }
    set->status = TL_NOT_CONVEX;
  }
}

/// x nearest to the centre that `set` was started at, over the rows. Rows are taken
/// in until none is missed by more than rounding, also after x was computed again
/// from the factors. Takes and leaves `sides`.
TL_INLINE void tl_solve_rows(
    TlActiveSet* set, const TlRowsOfLimits* rows, bool warm) {
  tl_add_start(set, rows, warm);
  bool settled = true;
  bool goes_on = true;
  while (goes_on) {
    const TlViolation violation = tl_most_violated(set, rows);
    if (violation.row >= 0) {
      if (set->left == 0) {
        set->status = TL_LIMIT;
        goes_on = false;
      } else {
        tl_enter(set, rows, &violation);
        settled = false;
      }
    } else {
      goes_on = !settled;
      if (goes_on) {
        tl_settle(set, rows);
      }
      settled = true;
    }
  }
  tl_finish(set, rows);
}
