#pragma once
// Forces of supports that balance passive joints, and those that carry nothing, for
// limited_torque.h.

#include "eights.h"
#include "square_root.h"

/// What of the robot is constant, and of shares what is asked for.
struct TlSupportLayout {
  int32_t passive[TL_PASSIVE_ENTRIES];  // velocities without a motor
  real force_weights[TL_HELD_ENTRIES];  // roots: 1, or the lever of a moment, m
#if TL_SHARES
  int32_t share_of[TL_HELD_ENTRIES];  // of arguments; -1: none, the row is whole
  int32_t share_of_task[TL_TASK_ENTRIES];
  real shares[TL_HELD_ENTRIES];  // to which rows are held
  real task_weights[TL_TASK_ENTRIES];  // 1 of a task that is done
#endif
};
typedef struct TlSupportLayout TlSupportLayout;

/// Forces of supports that balance passive joints, d_f = carry v, and those that
/// carry nothing, d_f = unbound z, where v are the entries `carried` of M d_qdd; the
/// other passive entries depend on them by `relations`. With J_sp the passive columns
/// of J_s, J_sp^T d_f = v.
struct TlForceBasis {
  int32_t present;  // held rows that have forces
  int32_t order[TL_HELD_ENTRIES];  // these rows first
  int32_t rank;  // of J_sp
  int32_t
      carried[TL_PASSIVE_ENTRIES];  // which of its columns are independent, of `rank`
  bool depends[TL_PASSIVE_ENTRIES];  // the others
  // Row j: parts of column j along those carried.
  real relations[TL_PASSIVE_ENTRIES * TL_PASSIVE_ENTRIES];
  real carry[TL_HELD_ENTRIES * TL_PASSIVE_ENTRIES];  // held x rank
  real unbound[TL_HELD_ENTRIES * TL_HELD_ENTRIES];  // held x (held - rank)
};
typedef struct TlForceBasis TlForceBasis;

/// A reflection that maps column `column` of W, rows x cols, from row `at` on, to its
/// first entry, applied to this column and those behind it up to `end`, in eights.
/// False, and no reflection, where the column's norm there is at most `least`, or no
/// row is left.
TL_INLINE bool tl_reflect_rows(real* W, int32_t rows, int32_t cols, int32_t end,
    int32_t at, int32_t column, real least) {
  real square = TL_ZERO;
  for (int32_t i = at; i < rows; ++i) {
    square += W[(i * cols) + column] * W[(i * cols) + column];
  }
  const real norm = tl_root(square);
  const bool reflects = (norm > least) && (at < rows);
  if (reflects) {
    real v[TL_MOST_ROWS];
    real along[TL_MOST_ROWS];
    for (int32_t i = 0; i < TL_MOST_ROWS; ++i) {
      v[i] = (i < rows) ? W[(i * cols) + column] : TL_ZERO;
    }
    const real first = v[at];
    const real to = (first > TL_ZERO) ? -norm : norm;
    v[at] = first - to;
    const real scale = TL_ONE / (norm * (norm + tl_size_of(first)));
    for (int32_t i = 0; i < TL_MOST_ROWS; ++i) {
      along[i] = scale * v[i];
    }
    tl_reflect_columns(&v[0], &along[0], at, rows, (column / 8) * 8, end, cols, W);
    W[(at * cols) + column] = to;
    for (int32_t i = at + 1; i < rows; ++i) {
      W[(i * cols) + column] = TL_ZERO;
    }
  }
  return reflects;
}

/// R^-1 times column `column` of W, down from row rank - 1, where R are the columns
/// carried.
TL_INLINE void tl_divide_by_carried(
    const TlForceBasis* basis, const real* W, int32_t column, real* parts) {
  for (int32_t r = basis->rank - 1; r >= 0; --r) {
    const real* const row = &W[r * TL_BASIS_COLS];
    real part = row[column];
    for (int32_t s = r + 1; s < basis->rank; ++s) {
      part -= row[basis->carried[s]] * parts[s];
    }
    parts[r] = part / row[basis->carried[r]];
  }
}

/// With [G, 1] = Q [R, Q^T], where G are the columns of J_sp that W begins with:
/// carry is S Q_1 R_11^-T, unbound S Q_2, relations R_11^-1 R_12, S the roots of
/// weights.
TL_INLINE void tl_read_force_basis(
    const TlSupportLayout* layout, TlForceBasis* basis, const real* W) {
  for (int32_t j = 0; j < TL_PASSIVE; ++j) {
    if (basis->depends[j]) {
      tl_divide_by_carried(basis, W, j, &basis->relations[j * TL_PASSIVE_ENTRIES]);
    }
  }
  for (int32_t i = 0; i < TL_HELD_ENTRIES; ++i) {
    const int32_t h = basis->order[i];
    const real weight = layout->force_weights[h];
    real* const carry = &basis->carry[h * TL_PASSIVE_ENTRIES];
    tl_divide_by_carried(basis, W, TL_PASSIVE_ENTRIES + i, carry);
    for (int32_t r = 0; r < basis->rank; ++r) {
      carry[r] *= weight;
    }
    for (int32_t k = basis->rank; k < TL_HELD_ENTRIES; ++k) {
      basis->unbound[(h * TL_HELD_ENTRIES) + k - basis->rank] =
          weight * W[(k * TL_BASIS_COLS) + TL_PASSIVE_ENTRIES + i];
    }
  }
}

#if TL_SHARES
/// Rows that are not held have no forces: those that are come first.
TL_INLINE void tl_put_present_first(
    const TlSupportLayout* layout, TlForceBasis* basis) {
  int32_t absent = TL_HELD_ROWS;
  basis->present = 0;
  for (int32_t h = 0; h < TL_HELD_ROWS; ++h) {
    if (layout->force_weights[h] > TL_ZERO) {
      basis->order[basis->present] = h;
      ++basis->present;
    }
  }
  for (int32_t h = TL_HELD_ROWS - 1; h >= 0; --h) {
    if (!(layout->force_weights[h] > TL_ZERO)) {
      --absent;
      basis->order[absent] = h;
    }
  }
}

#endif

/// Finds the basis of forces that J_s, held x velocities, has.
TL_INLINE void tl_find_force_basis(
    const TlSupportLayout* layout, const real* J_s, TlForceBasis* basis) {
  real W[TL_HELD_ENTRIES * TL_BASIS_COLS];
  real squares[TL_PASSIVE_ENTRIES];
  basis->present = TL_HELD_ROWS;
  for (int32_t i = 0; i < TL_HELD_ENTRIES; ++i) {
    basis->order[i] = i;
  }
  if (TL_SHARES) {
    tl_put_present_first(layout, basis);
  }
  for (int32_t j = 0; j < TL_PASSIVE_ENTRIES; ++j) {
    squares[j] = TL_ZERO;
    basis->depends[j] = false;
  }
  for (int32_t i = 0; i < TL_HELD_ENTRIES; ++i) {
    const int32_t h = basis->order[i];
    const real weight = layout->force_weights[h];
    real* const row = &W[i * TL_BASIS_COLS];
    for (int32_t j = 0; j < TL_PASSIVE_ENTRIES; ++j) {
      const real entry = weight * J_s[(h * TL_VELOCITIES) + layout->passive[j]];
      row[j] = entry;
      squares[j] += entry * entry;
    }
    for (int32_t j = TL_PASSIVE_ENTRIES; j < TL_BASIS_COLS; ++j) {
      row[j] = ((i + TL_PASSIVE_ENTRIES) == j) ? TL_ONE : TL_ZERO;
    }
  }
  basis->rank = 0;
  for (int32_t j = 0; j < TL_PASSIVE; ++j) {
    const real least = TL_RANK_TOLERANCE * tl_root(squares[j]);
    basis->depends[j] = !tl_reflect_rows(
        &W[0], TL_HELD_ENTRIES, TL_BASIS_COLS, TL_BASIS_COLS, basis->rank, j, least);
    if (!basis->depends[j]) {
      basis->carried[basis->rank] = j;
      ++basis->rank;
    }
  }
  tl_read_force_basis(layout, basis, &W[0]);
}
