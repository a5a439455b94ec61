#pragma once
// Derivatives of accelerations of a tree in one common frame: those of joint forces
// at the accelerations that result, solved for by M = L^T D L (RBDA section 6.5).

#include "force_derivatives.h"
#include "solve_columns.h"

/// Work space behind that of TlMotionArrays.
struct TlSolveArrays {
  real* own;  ///< the ten numbers of each link alone
  real* more;  ///< motion by accelerations (6), and the wrenches that it takes (6)
  real* qdd;  ///< accelerations
  real* inverse_D;  ///< 1 / D
  real* X;  ///< a strip
  real* L;  ///< a row of TL_PATH for each freedom
  real* path;  ///< rows of a strip that carry each other
  real* H;  ///< the same as L of M, and eight numbers
};
typedef struct TlSolveArrays TlSolveArrays;

TL_INLINE TlSolveArrays tl_divide_more_work(real* work) {
  const int32_t n = TL_PLACES;
  const TlSolveArrays arrays = {work, &work[10 * n], &work[22 * n], &work[23 * n],
      &work[24 * n], &work[48 * n], &work[(48 + TL_PATH) * n],
      &work[((48 + TL_PATH) * n) + (24 * TL_PATH)]};
  return arrays;
}

/// Rows that carry each, as ranges: two numbers, see TlTree.
struct TlPaths {
  const int16_t* ends;  ///< where each row's ranges end
  const int16_t* ranges;
};
typedef struct TlPaths TlPaths;

/// Rows of M = S^T P, of each what it has in the path of a freedom, then its own with
/// the rotor of `drives`. What is written beyond the end of a path is written again.
TL_INLINE void tl_multiply_paths(const TlTree* tree, const TlPaths* paths,
    const real* drives, const real* P, const real* S, real* H) {
  const int32_t n = TL_PLACES;
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    real* const row = &H[i * TL_PATH];
    real* to = row;
    for (int32_t e = tl_begin_ranges(paths->ends, i); e < paths->ends[i]; ++e) {
      const int32_t begin = paths->ranges[2 * e];
      const int32_t count = paths->ranges[(2 * e) + 1] - begin;
      for (int32_t j = 0; j < count; j += 8) {
        tl_multiply_eight(&P[i], &S[begin + j], 6, TL_NONE, TL_NONE, 1, 0, &to[j]);
      }
      to = &to[count];
    }
    real own = P[i] * S[i];
    for (int32_t k = n; k < (6 * n); k += n) {
      own = own + (P[k + i] * S[k + i]);
    }
    to[0] = own + drives[i];
    for (int32_t j = tree->depths[i] + 1; j < TL_PATH; ++j) {
      row[j] = TL_ZERO;
    }
  }
}

/// D of row i of H, and the row of L.
TL_INLINE void tl_finish_row(
    int32_t depth, int32_t i, const real* H, real* L, real* inverse_D) {
  const real inverse = TL_ONE / H[(i * TL_PATH) + depth];
  inverse_D[i] = inverse;
  for (int32_t j = 0; j < TL_PATH; ++j) {
    L[(i * TL_PATH) + j] = inverse * H[(i * TL_PATH) + j];
  }
}

/// Subtracts from row i of H, or from that and the next, what the rows behind them
/// carry, times their factors, and the same from x.
TL_INLINE TREELINE_IN_PLACE void tl_subtract_factored(
    bool two, const TlTree* tree, int32_t i, const real* L, real* H, real* x) {
  const int32_t next = two ? (i + 1) : i;
  const int32_t last = tree->beyond[i] - 1;
  const real* const column = &L[tree->depths[i]];
  real upper = x[i];
  real lower = x[next];
  for (int32_t k = last; k > next; --k) {
    upper = upper - (column[k * TL_PATH] * x[k]);
    if (two) {
      lower = lower - (column[(k * TL_PATH) + 1] * x[k]);
    }
  }
  x[next] = lower;
  x[i] = upper;
  for (int32_t j = 0; j <= tree->depths[next]; j += 8) {
    real* const row = &H[(i * TL_PATH) + j];
    TlStripRows rows;
    tl_load_rows(two, TL_REGISTERS, TL_NONE, TL_PATH, row, &rows);
    tl_subtract_carried(two, TL_REGISTERS, &column[last * TL_PATH], -TL_PATH, 1,
        &H[(last * TL_PATH) + j], -TL_PATH, last - next, &rows);
    tl_store_rows(two, TL_REGISTERS, TL_PATH, &rows, row);
  }
}

/// Subtracts from row i of H, and from x, the row behind it times its factor.
TL_INLINE void tl_subtract_next(
    int32_t depth, int32_t i, const real* L, real* H, real* x) {
  const real factor = L[((i + 1) * TL_PATH) + depth];
  real* const row = &H[i * TL_PATH];
  for (int32_t j = 0; j < TL_PATH; ++j) {
    row[j] = row[j] - (factor * row[TL_PATH + j]);
  }
  x[i] = x[i] - (factor * x[i + 1]);
}

/// Factors M = L^T D L, of which H has the rows, and makes L^-T x of x. Two rows of a
/// limb share what they read.
TL_INLINE void tl_factor_paths(
    const TlTree* tree, real* H, real* L, real* inverse_D, real* x) {
  for (int32_t i = TL_VELOCITIES - 1; i >= 0; --i) {
    if ((i > 0) && tl_extends_path(tree, i)) {
      --i;
      const int32_t depth = tree->depths[i];
      tl_subtract_factored(true, tree, i, L, H, x);
      tl_finish_row(depth + 1, i + 1, H, L, inverse_D);
      tl_subtract_next(depth, i, L, H, x);
    } else {
      tl_subtract_factored(false, tree, i, L, H, x);
    }
    tl_finish_row(tree->depths[i], i, H, L, inverse_D);
  }
}

/// Makes L^-1 D^-1 x of x. `path` is work space, as in tl_carry_rows_outward.
TL_INLINE void tl_solve_outward(
    const TlTree* tree, const real* L, const real* inverse_D, real* path, real* x) {
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    const real* const factors = &L[i * TL_PATH];
    const int32_t depth = tree->depths[i];
    real rest = x[i] * inverse_D[i];
    for (int32_t k = 0; k < depth; ++k) {
      rest = rest - (factors[k] * path[k]);
    }
    path[depth] = rest;
    x[i] = rest;
  }
}

/// Adds to the motion of links that accelerations of joints make, and to wrenches
/// what it takes.
TL_INLINE void tl_accelerate(
    const int16_t* parents, const TlSolveArrays* solve, const TlMotionArrays* of) {
  real* const more = solve->more;
  real* const wrench = &more[6 * TL_PLACES];
  real* const force = &of->body[22 * TL_PLACES];
  for (int32_t k = 0; k < (6 * TL_PLACES); ++k) {
    more[k] = TL_ZERO;
  }
  tl_find_velocities(parents, of->S, solve->qdd, more);
  tl_multiply_inertias(solve->own, more, wrench);
  tl_add_up(parents, 6, wrench);
  if (TL_FLOATS) {
    tl_share_base(6, wrench);
  }
  for (int32_t k = 0; k < (6 * TL_PLACES); ++k) {
    of->a[k] = of->a[k] + more[k];
    force[k] = force[k] + wrench[k];
  }
}

/// Joint forces that are left for accelerations: `net` less those that motion takes.
TL_INLINE void tl_find_rest(const real* net, const TlMotionArrays* of, real* rest) {
  const int32_t n = TL_PLACES;
  const real* const force = &of->body[22 * n];
  const real* const S = of->S;
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    real taken = S[i] * force[i];
    for (int32_t k = n; k < (6 * n); k += n) {
      taken = taken + (S[k + i] * force[k + i]);
    }
    rest[i] = net[i] - taken;
  }
}

TL_INLINE void tl_negate(int32_t count, real* numbers) {
  for (int32_t k = 0; k < count; ++k) {
    numbers[k] = -numbers[k];
  }
}

/// Eight columns of a matrix, see tl_multiply_blocks.
TL_INLINE TREELINE_IN_PLACE void tl_multiply_columns(const TlBlocks* blocks,
    int32_t column, const real* A, const real* X, int32_t length, const real* B,
    const real* Y, int32_t stride, real* to) {
  const int32_t count = TL_PLACES / 8;
  const int32_t from_right = (count - 1) - (column / 8);
  for (int32_t b = 0; b < count; ++b) {
    tl_multiply_block(blocks, (b * count) + from_right, A, X, length, B, Y, 8, stride,
        &to[8 * b * stride]);
  }
}

/// Eight columns of the derivatives of joint forces, negative, as a strip.
TL_INLINE void tl_fill_strip(const TlBlocks* blocks, int32_t column,
    const real* drives, const real* rates, const TlMotionArrays* of, real* X) {
  const int32_t end = tl_lesser(column + 8, TL_VELOCITIES);
  tl_multiply_columns(blocks, column, of->P, of->by_q, 9, of->S, of->T, 24, X);
  tl_multiply_columns(blocks, column, of->P, of->by_qd, 9, of->S, of->U, 24, &X[8]);
  for (int32_t i = column; i < end; ++i) {
    real* const row = &X[(24 * i) + (i - column)];
    row[0] = row[0] - drives[TL_VELOCITIES + i];
    row[8] = row[8] - rates[(2 * TL_VELOCITIES) + i];
  }
}

/// Derivatives of accelerations with respect to displacements, velocities and joint
/// forces. `rates` has qd, joint forces less friction and springs, slopes of friction
/// and, three numbers, the acceleration that stands for gravity, up; `drives` what
/// rotors add to the diagonal of M, and stiffnesses. What begins with `beyond` is a
/// TlTree, with `path_ends` a TlPaths.
TL_INLINE void tl_acceleration_derivatives(const real* links, const real* joints,
    const real* drives, const int16_t* parents, const int16_t* blocks,
    const int16_t* keeps, const real* kept, const int16_t* beyond,
    const int16_t* depths, const int16_t* strip_ends, const int16_t* strips,
    const int16_t* path_ends, const int16_t* paths, const real* R, const real* p,
    const real* rates, real* work, real* by_q, real* by_qd, real* inverse) {
  const int32_t n = TL_PLACES;
  const TlMotionArrays of = tl_divide_work(work);
  const TlSolveArrays solve = tl_divide_more_work(&work[85 * n]);
  const TlBlocks all = {blocks, (n / 8) * (n / 8), keeps, kept};
  const TlTree tree = {beyond, depths, strip_ends, strips};
  const TlPaths along = {path_ends, paths};
  const real* const up = &rates[3 * TL_VELOCITIES];
  tl_begin_motion(links, joints, parents, R, p, rates, &of);
  for (int32_t k = 0; k < (10 * n); ++k) {
    solve.own[k] = of.body[k];
  }
  for (int32_t i = 0; i < n; ++i) {
    solve.qdd[i] = TL_ZERO;
  }
  tl_find_accelerations(parents, of.S, of.T, rates, solve.qdd, up, of.a);
  tl_add_up_links(parents, &of);
  tl_find_rest(&rates[TL_VELOCITIES], &of, solve.qdd);
  tl_multiply_inertias(of.body, of.S, of.P);
  tl_multiply_paths(&tree, &along, drives, of.P, of.S, solve.H);
  tl_factor_paths(&tree, solve.H, solve.L, solve.inverse_D, solve.qdd);
  tl_solve_outward(&tree, solve.L, solve.inverse_D, solve.path, solve.qdd);
  tl_accelerate(parents, &solve, &of);
  tl_find_changes(up, &of);
  tl_negate(9 * n, of.P);
  tl_negate(12 * n, of.T);
  for (int32_t column = 0; column < TL_VELOCITIES; column += 8) {
    tl_fill_strip(&all, column, drives, rates, &of, solve.X);
    tl_solve_strip(&tree, column, solve.L, solve.inverse_D, solve.X, solve.path, by_q,
        by_qd, inverse);
  }
}
