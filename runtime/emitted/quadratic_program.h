#pragma once
// The point nearest to a centre within rows of limits, of fixed size: minimises |x -
// center|^2 / 2 with lowest <= x and lower <= A x <= upper. No heap, a stated bound
// on the work.
//
// The dual active-set method of Goldfarb & Idnani (Math. Programming 27, 1983). It
// starts at the centre and makes one violated row active after the other; rows whose
// multiplier would change its sign leave. With the active rows' normals n_j as
// columns of B,
//
//     J = Q,   J^T B = (R; 0),   R upper triangular,
//
// where Q is orthogonal: Householder reflections add a row, Givens rotations take one
// out. The active rows of the last cycle are the start. When a violated row depends
// on active rows that cannot leave, no x obeys all of them: that row is set aside and
// the rest is solved.

#include "eights.h"
#include "square_root.h"

/// Rows lowest <= x <= highest and lower <= A x <= upper, A row-major; equal for an
/// equation. Of all rows the first TL_UNKNOWNS are those of x.
struct TlRowsOfLimits {
  real lowest[TL_UNKNOWNS];
  real highest[TL_UNKNOWNS];
  real A[TL_LIMIT_ROWS * TL_UNKNOWNS];
  real lower[TL_LIMIT_ROWS];
  real upper[TL_LIMIT_ROWS];
};
typedef struct TlRowsOfLimits TlRowsOfLimits;

/// The state of the method: x, the active rows, their multipliers and factors.
struct TlActiveSet {
  real x[TL_UNKNOWNS];
  int32_t sides[TL_ALL_ROWS];
  int32_t status;
  int32_t iterations;
  int32_t left;  // iterations
  int32_t count;  // of active rows
  bool ignored[TL_ALL_ROWS];  // depends on active rows, holds but for rounding
  real tolerance[TL_ALL_ROWS];  // share of its terms by which a row may be missed
  real inverse_squares[TL_LIMIT_ROWS];
  real center[TL_UNKNOWNS];
  real Jt[TL_UNKNOWNS * TL_UNKNOWNS];  // the columns of J as rows
  real R[TL_UNKNOWNS * TL_UNKNOWNS];
  int32_t active[TL_UNKNOWNS];
  real u[TL_UNKNOWNS];
  real d[TL_UNKNOWNS];
  real r[TL_UNKNOWNS];
};
typedef struct TlActiveSet TlActiveSet;

/// The row that is missed most.
struct TlViolation {
  int32_t row;
  int32_t side;
  real amount;  // by which the row is missed
  real tolerance;  // of a contradiction
};
typedef struct TlViolation TlViolation;

TL_INLINE real tl_size_of(real x) {
  return (x < TL_ZERO) ? -x : x;
}

/// False for NaN and infinities.
TL_INLINE bool tl_is_finite(real x) {
  return (x - x) == TL_ZERO;
}

/// Sum of the sizes of TL_UNKNOWNS products.
TL_INLINE real tl_dot_of_sizes(const real* a, const real* b) {
  real sums[8];
  for (int32_t k = 0; k < 8; ++k) {
    sums[k] = TL_ZERO;
  }
  for (int32_t i = 0; i < TL_UNKNOWNS; i += 8) {
    for (int32_t k = 0; k < 8; ++k) {
      sums[k] += tl_size_of(a[i + k] * b[i + k]);
    }
  }
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) +
      ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

/// x + sum of factors[k] times row k of `rows`, k from `first` to before `last`.
TL_INLINE void tl_add_rows(
    const real* factors, const real* rows, int32_t first, int32_t last, real* x) {
  real sum[TL_UNKNOWNS];
  for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
    sum[i] = x[i];
  }
  for (int32_t k = first; k < last; ++k) {
    const real factor = factors[k];
    for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
      sum[i] += factor * rows[(k * TL_UNKNOWNS) + i];
    }
  }
  for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
    x[i] = sum[i];
  }
}

TL_INLINE real tl_lower_of(const TlRowsOfLimits* rows, int32_t row) {
  return (row < TL_UNKNOWNS) ? rows->lowest[row] : rows->lower[row - TL_UNKNOWNS];
}

TL_INLINE real tl_upper_of(const TlRowsOfLimits* rows, int32_t row) {
  return (row < TL_UNKNOWNS) ? rows->highest[row] : rows->upper[row - TL_UNKNOWNS];
}

TL_INLINE bool tl_is_equation(const TlRowsOfLimits* rows, int32_t row) {
  return tl_lower_of(rows, row) == tl_upper_of(rows, row);
}

/// +1 where the row's normal is its row of A, -1 where it is the opposite.
TL_INLINE real tl_sign_of(int32_t side) {
  return (side == TL_UPPER) ? -TL_ONE : TL_ONE;
}

/// The row of A as an array.
TL_INLINE const real* tl_row_of(const TlRowsOfLimits* rows, int32_t row) {
  return &rows->A[(row - TL_UNKNOWNS) * TL_UNKNOWNS];
}

/// d = J^T n of the row's normal.
TL_FUNCTION void tl_project_normal(
    TlActiveSet* set, const TlRowsOfLimits* rows, int32_t row, int32_t side) {
  for (int32_t k = 0; k < TL_UNKNOWNS; ++k) {
    const real* const axis = &set->Jt[k * TL_UNKNOWNS];
    const real along =
        (row < TL_UNKNOWNS) ? axis[row] : tl_dot(axis, tl_row_of(rows, row));
    set->d[k] = tl_sign_of(side) * along;
  }
}

/// |J_2^T n|: how far the normal is from those of active rows.
TL_INLINE real tl_free_part(const TlActiveSet* set) {
  real square = TL_ZERO;
  for (int32_t k = set->count; k < TL_UNKNOWNS; ++k) {
    square += set->d[k] * set->d[k];
  }
  return tl_root(square);
}

TL_INLINE bool tl_depends(const TlActiveSet* set, real apart) {
  const real least = TL_DEPENDENT * tl_root(tl_dot(&set->d[0], &set->d[0]));
  return (set->count == TL_UNKNOWNS) || (!(apart > least));
}

/// r = R^-1 r.
TL_INLINE void tl_solve_back(TlActiveSet* set) {
  for (int32_t j = set->count - 1; j >= 0; --j) {
    set->r[j] /= set->R[(j * TL_UNKNOWNS) + j];
    for (int32_t i = 0; i < j; ++i) {
      set->r[i] -= set->R[(i * TL_UNKNOWNS) + j] * set->r[j];
    }
  }
}

/// Reflects J_2 so that J_2^T n is along its first column. There is room for a row.
TL_FUNCTION void tl_add_row(
    TlActiveSet* set, int32_t row, int32_t side, real apart, real multiplier) {
  const int32_t at = set->count;
  const real first = set->d[at];
  const real to = (first > TL_ZERO) ? -apart : apart;
  real v[TL_UNKNOWNS];
  real sum[TL_UNKNOWNS];
  for (int32_t k = 0; k < TL_UNKNOWNS; ++k) {
    v[k] = set->d[k];
    sum[k] = TL_ZERO;
  }
  v[at] -= to;
  const real scale = TL_ONE / (apart * (apart + tl_size_of(first)));
  tl_add_rows(&v[0], &set->Jt[0], at, TL_UNKNOWNS, &sum[0]);
  for (int32_t k = at; k < TL_UNKNOWNS; ++k) {
    const real along = scale * v[k];
    for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
      set->Jt[(k * TL_UNKNOWNS) + i] -= along * sum[i];
    }
  }
  for (int32_t k = 0; k < at; ++k) {
    set->R[(k * TL_UNKNOWNS) + at] = set->d[k];
  }
  set->R[(at * TL_UNKNOWNS) + at] = to;
  set->u[at] = multiplier;
  set->active[at] = row;
  set->sides[row] = side;
  set->count = at + 1;
}

/// a, b <- c a + s b, c b - s a.
TL_INLINE void tl_turn_pair(real c, real s, real* a, real* b) {
  const real turned = (c * *a) + (s * *b);
  *b = (c * *b) - (s * *a);
  *a = turned;
}

/// Makes column k of R upper triangular again, by a rotation of rows k and k + 1.
TL_INLINE void tl_rotate(TlActiveSet* set, int32_t k) {
  real* const upper = &set->R[k * TL_UNKNOWNS];
  real* const lower = &set->R[(k + 1) * TL_UNKNOWNS];
  const real length = tl_root((upper[k] * upper[k]) + (lower[k] * lower[k]));
  const real c = upper[k] / length;
  const real s = lower[k] / length;
  for (int32_t j = k; j < set->count; ++j) {
    tl_turn_pair(c, s, &upper[j], &lower[j]);
  }
  for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
    tl_turn_pair(
        c, s, &set->Jt[(k * TL_UNKNOWNS) + i], &set->Jt[((k + 1) * TL_UNKNOWNS) + i]);
  }
  tl_turn_pair(c, s, &set->d[k], &set->d[k + 1]);
}

/// Takes an active row out; rotates J, R and d. It has to be missed by more to come
/// back: where more rows meet than there are unknowns, as at the tip of a cone,
/// roundings would exchange them for ever.
TL_INLINE void tl_drop_row(TlActiveSet* set, int32_t index) {
  const int32_t dropped = set->active[index];
  const real looser = TL_TEN * set->tolerance[dropped];
  set->sides[dropped] = TL_FREE;
  set->tolerance[dropped] =
      (looser < TL_LOOSEST_TOLERANCE) ? looser : TL_LOOSEST_TOLERANCE;
  for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
    set->ignored[row] = false;
  }
  --set->count;
  for (int32_t j = index; j < set->count; ++j) {
    set->active[j] = set->active[j + 1];
    set->u[j] = set->u[j + 1];
    for (int32_t i = 0; i <= (j + 1); ++i) {
      set->R[(i * TL_UNKNOWNS) + j] = set->R[(i * TL_UNKNOWNS) + j + 1];
    }
  }
  for (int32_t k = index; k < set->count; ++k) {
    tl_rotate(set, k);
  }
}

/// Moves x along the active rows until they hold, and changes their multipliers
/// accordingly: R^T y = b - B^T x, x += J_1 y, u += R^-1 y.
TL_INLINE void tl_correct(TlActiveSet* set, const TlRowsOfLimits* rows) {
  for (int32_t j = 0; j < set->count; ++j) {
    const int32_t row = set->active[j];
    const real value =
        (row < TL_UNKNOWNS) ? set->x[row] : tl_dot(tl_row_of(rows, row), &set->x[0]);
    real y = (set->sides[row] == TL_UPPER) ? (value - tl_upper_of(rows, row))
                                           : (tl_lower_of(rows, row) - value);
    for (int32_t i = 0; i < j; ++i) {
      y -= set->R[(i * TL_UNKNOWNS) + j] * set->r[i];
    }
    set->r[j] = y / set->R[(j * TL_UNKNOWNS) + j];
  }
  tl_add_rows(&set->r[0], &set->Jt[0], 0, set->count, &set->x[0]);
  tl_solve_back(set);
  for (int32_t j = 0; j < set->count; ++j) {
    set->u[j] += set->r[j];
  }
}

/// x and the multipliers of the active rows from the factors.
TL_INLINE void tl_find_multipliers(TlActiveSet* set, const TlRowsOfLimits* rows) {
  for (int32_t i = 0; i < TL_UNKNOWNS; ++i) {
    set->x[i] = set->center[i];
  }
  for (int32_t j = 0; j < set->count; ++j) {
    set->u[j] = TL_ZERO;
  }
  tl_correct(set, rows);
}

/// The minimum over the active rows, without those whose multiplier has the wrong
/// sign.
TL_FUNCTION void tl_settle(TlActiveSet* set, const TlRowsOfLimits* rows) {
  bool settled = false;
  while (!settled) {
    tl_find_multipliers(set, rows);
    int32_t worst = -1;
    for (int32_t j = 0; j < set->count; ++j) {
      const bool leaves =
          (set->u[j] < TL_ZERO) && (!tl_is_equation(rows, set->active[j]));
      const int32_t against = (worst < 0) ? j : worst;
      worst = (leaves && ((worst < 0) || (set->u[j] < set->u[against]))) ? j : worst;
    }
    settled = worst < 0;
    if (!settled) {
      tl_drop_row(set, worst);
      ++set->iterations;
    }
  }
}
