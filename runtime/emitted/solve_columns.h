#pragma once
// M X = B for the columns of two matrices and of the unit matrix, where M = L^T D L
// is the mass matrix of a tree: L has zeros where M has (Featherstone, RBDA
// section 6.5). Eight columns of all three at a time, a strip of 24 numbers a row,
// which stays in the nearest cache. No branch on data.

#include <stdbool.h>

#include "ending_sizes.h"
#include "registers.h"

/// Which rows carry which. Row i of L has its factors with the rows that carry it,
/// those of its path, from the first on, without gaps. Ranges are two numbers, the
/// first row and the one behind the last; lists of them go upward.
struct TlTree {
  const int16_t* beyond;  ///< behind the last of the rows that each carries
  const int16_t* depths;  ///< how many rows carry each
  const int16_t* strip_ends;  ///< where each strip's ranges in `strips` end
  const int16_t* strips;  ///< rows in which each strip has entries
};
typedef struct TlTree TlTree;

/// Where the rows of a strip's three matrices go, `stride` apart.
struct TlStripResults {
  real* to[3];
  int32_t stride;
};
typedef struct TlStripResults TlStripResults;

/// A row of a strip, or two that follow each other, in registers.
struct TlStripRows {
  TlRegister upper[3 * TL_REGISTERS];
  TlRegister lower[3 * TL_REGISTERS];
};
typedef struct TlStripRows TlStripRows;

TL_INLINE int32_t tl_lesser(int32_t a, int32_t b) {
  return (a < b) ? a : b;
}

TL_INLINE int32_t tl_greater(int32_t a, int32_t b) {
  return (a < b) ? b : a;
}

TL_INLINE int32_t tl_begin_ranges(const int16_t* ends, int32_t i) {
  return (i > 0) ? ends[i - 1] : 0;
}

/// Whether row `i` is the only one that the row before carries without another
/// between.
TL_INLINE bool tl_extends_path(const TlTree* tree, int32_t i) {
  return (tree->depths[i] == (tree->depths[i - 1] + 1)) &&
      (tree->beyond[i] == tree->beyond[i - 1]);
}

/// Numbers at `row` that several operations take. Without this g++ reads them for
/// each of them, and some processors read 64 bytes once a cycle.
TL_INLINE TREELINE_IN_PLACE TlRegister tl_load_once(const real* row) {
  TlRegister numbers = tl_load(row);
#if TREELINE_REGISTER_BYTES == 64
  __asm__("" : "+v"(numbers));
#endif
  return numbers;
}

/// Loads `registers` of a row, or of two, `stride` apart, each times its scale.
TL_INLINE TREELINE_IN_PLACE void tl_load_rows(bool two, int32_t registers,
    const real* scales, int32_t stride, const real* X, TlStripRows* rows) {
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < registers; ++k) {
    const TlRegister upper = tl_load(&X[k * TL_WIDTH]);
    rows->upper[k] = (scales == TL_NONE) ? upper : (scales[0] * upper);
    if (two) {
      const TlRegister lower = tl_load(&X[stride + (k * TL_WIDTH)]);
      rows->lower[k] = (scales == TL_NONE) ? lower : (scales[1] * lower);
    }
  }
}

TL_INLINE TREELINE_IN_PLACE void tl_store_rows(
    bool two, int32_t registers, int32_t stride, const TlStripRows* rows, real* X) {
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < registers; ++k) {
    tl_store(rows->upper[k], &X[k * TL_WIDTH]);
    if (two) {
      tl_store(rows->lower[k], &X[stride + (k * TL_WIDTH)]);
    }
  }
}

/// Subtracts `count` rows of a strip, `step` apart, times their factors. Those of the
/// lower row are `next` behind.
TL_INLINE TREELINE_IN_PLACE void tl_subtract_carried(bool two, int32_t registers,
    const real* factors, int32_t factor_step, int32_t next, const real* X,
    int32_t step, int32_t count, TlStripRows* rows) {
  for (int32_t c = 0; c < count; ++c) {
    const real* const factor = &factors[c * factor_step];
    const real* const row = &X[c * step];
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < registers; ++k) {
      const TlRegister x = tl_load_once(&row[k * TL_WIDTH]);
      rows->upper[k] = rows->upper[k] - (factor[0] * x);
      if (two) {
        rows->lower[k] = rows->lower[k] - (factor[next] * x);
      }
    }
  }
}

/// Row i of L^-T X, or that and the next, in the ranges from the first on. The unit
/// matrix has no entries from row `end` on.
TL_INLINE TREELINE_IN_PLACE void tl_carry_rows_inward(bool two, const TlTree* tree,
    const int16_t* ranges, int32_t range_count, int32_t end, const real* L, int32_t i,
    real* X) {
  const int32_t all = 3 * TL_REGISTERS;
  const real* const column = &L[tree->depths[i]];
  const int32_t next = two ? (i + 1) : i;
  TlStripRows rows;
  tl_load_rows(two, all, TL_NONE, 24, &X[i * 24], &rows);
  for (int32_t h = range_count - 1; h >= 0; --h) {
    const int32_t begin = tl_greater(ranges[2 * h], next + 1);
    const int32_t last = tl_lesser(ranges[(2 * h) + 1], tree->beyond[i]) - 1;
    const int32_t split = tl_greater(begin, end);
    const int32_t rest = tl_lesser(last, end - 1);
    tl_subtract_carried(two, 2 * TL_REGISTERS, &column[last * TL_PATH], -TL_PATH, 1,
        &X[last * 24], -24, (last - split) + 1, &rows);
    tl_subtract_carried(two, all, &column[rest * TL_PATH], -TL_PATH, 1, &X[rest * 24],
        -24, (rest - begin) + 1, &rows);
  }
  if (two) {
    const real factor = column[next * TL_PATH];
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < all; ++k) {
      rows.upper[k] = rows.upper[k] - (factor * rows.lower[k]);
    }
  }
  tl_store_rows(two, all, 24, &rows, &X[i * 24]);
}

/// L^-T X in the rows where a strip has entries.
TL_INLINE void tl_carry_inward(const TlTree* tree, const int16_t* ranges,
    int32_t range_count, int32_t end, const real* L, real* X) {
  for (int32_t g = range_count - 1; g >= 0; --g) {
    const int16_t* const range = &ranges[2 * g];
    int32_t i = range[1] - 1;
    while (i >= range[0]) {
      if ((i > range[0]) && tl_extends_path(tree, i)) {
        --i;
        tl_carry_rows_inward(true, tree, range, range_count - g, end, L, i, X);
      } else {
        tl_carry_rows_inward(false, tree, range, range_count - g, end, L, i, X);
      }
      --i;
    }
  }
}

/// Stores so many registers of a row of a strip in row i of its results.
TL_INLINE TREELINE_IN_PLACE void tl_store_results(int32_t registers,
    const TlRegister* row, int32_t i, const TlStripResults* results) {
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < registers; ++k) {
    real* const to = results->to[k / TL_REGISTERS];
    tl_store(row[k], &to[(i * results->stride) + ((k % TL_REGISTERS) * TL_WIDTH)]);
  }
}

/// So many registers of row i of L^-1 D^-1 X, or of that and the next. `path` has the
/// rows that carry them by depth, and gets these.
TL_INLINE TREELINE_IN_PLACE void tl_carry_rows_outward(bool two, int32_t registers,
    int32_t depth, const real* L, const real* inverse_D, int32_t i, const real* X,
    real* path, const TlStripResults* results) {
  const real* const factors = &L[i * TL_PATH];
  TlStripRows rows;
  tl_load_rows(two, registers, &inverse_D[i], 24, &X[i * 24], &rows);
  tl_subtract_carried(two, registers, factors, 1, TL_PATH, path, 24, depth, &rows);
  if (two) {
    const real factor = factors[TL_PATH + depth];
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < registers; ++k) {
      rows.lower[k] = rows.lower[k] - (factor * rows.upper[k]);
    }
    tl_store_results(registers, rows.lower, i + 1, results);
  }
  tl_store_results(registers, rows.upper, i, results);
  tl_store_rows(two, registers, 24, &rows, &path[depth * 24]);
}

/// L^-1 D^-1 X in rows `begin` to `end`.
TL_INLINE TREELINE_IN_PLACE void tl_carry_outward(int32_t registers,
    const TlTree* tree, int32_t begin, int32_t end, const real* L,
    const real* inverse_D, const real* X, real* path, const TlStripResults* results) {
  int32_t i = begin;
  while (i < end) {
    const int32_t depth = tree->depths[i];
    if (((i + 1) < end) && tl_extends_path(tree, i + 1)) {
      tl_carry_rows_outward(
          true, registers, depth, L, inverse_D, i, X, path, results);
      ++i;
    } else {
      tl_carry_rows_outward(
          false, registers, depth, L, inverse_D, i, X, path, results);
    }
    ++i;
  }
}

/// Copies a third of a strip to the last columns of a matrix, fewer than eight. There
/// all rows but the last are read and written whole, which is faster than parts.
TL_INLINE void tl_copy_strip(
    int32_t rows, int32_t columns, const real* from, real* to) {
  const int32_t n = TL_VELOCITIES;
  const int32_t last = rows - 1;
  for (int32_t i = 0; i < last; ++i) {
    for (int32_t j = 0; j < 8; ++j) {
      const int32_t at = (i * n) + j;
      to[at] = (j < columns) ? from[(i * 24) + j] : to[at];
    }
  }
  for (int32_t j = 0; j < columns; ++j) {
    to[(last * n) + j] = from[(last * 24) + j];
  }
}

/// Solves for the columns from `column` on, of which X has those of the two matrices,
/// and writes what it has then to the results. `path` is work space for TL_PATH rows
/// of a strip.
TL_INLINE void tl_solve_strip(const TlTree* tree, int32_t column, const real* L,
    const real* inverse_D, real* X, real* path, real* A, real* B, real* inverse) {
  const int32_t n = TL_VELOCITIES;
  const int32_t end = tl_lesser(column + 8, n);
  const int32_t columns = end - column;
  const int32_t begin = tl_begin_ranges(tree->strip_ends, column / 8);
  for (int32_t i = 0; i < n; ++i) {
    for (int32_t j = 0; j < 8; ++j) {
      X[(i * 24) + 16 + j] = (i == (column + j)) ? TL_ONE : TL_ZERO;
    }
  }
  tl_carry_inward(tree, &tree->strips[2 * begin],
      tree->strip_ends[column / 8] - begin, end, L, X);
  // The last columns, fewer than eight, go back to X: as eight they would be written
  // beyond the end.
  const bool whole = columns == 8;
  const TlStripResults results = {{whole ? &A[column] : X, whole ? &B[column] : &X[8],
                                      whole ? &inverse[column] : &X[16]},
      whole ? n : 24};
  tl_carry_outward(3 * TL_REGISTERS, tree, 0, end, L, inverse_D, X, path, &results);
  tl_carry_outward(2 * TL_REGISTERS, tree, end, n, L, inverse_D, X, path, &results);
  if (!whole) {
    tl_copy_strip(n, columns, X, &A[column]);
    tl_copy_strip(n, columns, &X[8], &B[column]);
    tl_copy_strip(end, columns, &X[16], &inverse[column]);
  }
  for (int32_t j = 0; j < columns; ++j) {
    for (int32_t i = 0; i < column; ++i) {
      inverse[((column + j) * n) + i] = results.to[2][(i * results.stride) + j];
    }
  }
}

/// M^-1 A, M^-1 B and M^-1. `X` has the columns of A and B strip by strip, 24 n
/// numbers each, of which the last third of each row is left free. `L` has a row of
/// TL_PATH for each freedom, `inverse_D` 1 / D. `path` is work space for 24 TL_PATH
/// numbers.
TL_INLINE void tl_solve_columns(const int16_t* beyond, const int16_t* depths,
    const int16_t* strip_ends, const int16_t* strips, const real* L,
    const real* inverse_D, real* X, real* path, real* A, real* B, real* inverse) {
  const TlTree tree = {beyond, depths, strip_ends, strips};
  for (int32_t column = 0; column < TL_VELOCITIES; column += 8) {
    tl_solve_strip(&tree, column, L, inverse_D, &X[3 * column * TL_VELOCITIES], path,
        A, B, inverse);
  }
}
