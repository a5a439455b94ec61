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
  real* H;  ///< the same of M, and eight numbers
};
typedef struct TlSolveArrays TlSolveArrays;

TL_INLINE TlSolveArrays tl_divide_more_work(real* work) {
  const int32_t n = TL_PLACES;
  const TlSolveArrays arrays = {work, &work[10 * n], &work[22 * n], &work[23 * n],
      &work[24 * n], &work[48 * n], &work[(48 + TL_PATH) * n]};
  return arrays;
}

/// Rows of M = S^T P, of each what it has in the path of a freedom, then its own with
/// the rotor of `drives`. What is written beyond the end of a path is written again.
TL_INLINE void tl_multiply_paths(
    const TlTree* tree, const real* drives, const real* P, const real* S, real* H) {
  const int32_t n = TL_PLACES;
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    real* const row = &H[i * TL_PATH];
    real* to = row;
    for (int32_t e = tl_begin_ranges(tree->path_ends, i); e < tree->path_ends[i];
         ++e) {
      const int32_t begin = tree->paths[2 * e];
      const int32_t count = tree->paths[(2 * e) + 1] - begin;
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

/// Factors M = L^T D L, of which H has the rows, and makes L^-T x of x.
TL_INLINE void tl_factor_paths(
    const TlTree* tree, real* H, real* L, real* inverse_D, real* x) {
  for (int32_t i = TL_VELOCITIES - 1; i >= 0; --i) {
    const int32_t last = tree->beyond[i] - 1;
    const int32_t depth = tree->depths[i];
    const real* const column = &L[depth];
    real* const row = &H[i * TL_PATH];
    real rest = x[i];
    for (int32_t k = last; k > i; --k) {
      rest = rest - (column[k * TL_PATH] * x[k]);
    }
    x[i] = rest;
    for (int32_t j = 0; j <= depth; j += 8) {
      TlStripRows rows;
      tl_load_rows(false, TL_REGISTERS, TL_NONE, &row[j], &rows);
      tl_subtract_carried(false, TL_REGISTERS, &column[last * TL_PATH], -TL_PATH, 0,
          &H[(last * TL_PATH) + j], -TL_PATH, last - i, &rows);
      tl_store_rows(false, TL_REGISTERS, &rows, &row[j]);
    }
    const real inverse = TL_ONE / row[depth];
    inverse_D[i] = inverse;
    for (int32_t j = 0; j < TL_PATH; ++j) {
      L[(i * TL_PATH) + j] = inverse * row[j];
    }
  }
}

/// Makes L^-1 D^-1 x of x.
TL_INLINE void tl_solve_outward(
    const TlTree* tree, const real* L, const real* inverse_D, real* x) {
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    const real* factor = &L[i * TL_PATH];
    real rest = x[i] * inverse_D[i];
    for (int32_t e = tl_begin_ranges(tree->path_ends, i); e < tree->path_ends[i];
         ++e) {
      for (int32_t k = tree->paths[2 * e]; k < tree->paths[(2 * e) + 1]; ++k) {
        rest = rest - (*factor * x[k]);
        ++factor;
      }
    }
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
/// TlTree.
TL_INLINE void tl_acceleration_derivatives(const real* links, const real* joints,
    const real* drives, const int16_t* parents, const int16_t* blocks,
    const int16_t* keeps, const real* kept, const int16_t* beyond,
    const int16_t* depths, const int16_t* path_ends, const int16_t* paths,
    const int16_t* strip_ends, const int16_t* strips, const real* R, const real* p,
    const real* rates, real* work, real* by_q, real* by_qd, real* inverse) {
  const int32_t n = TL_PLACES;
  const TlMotionArrays of = tl_divide_work(work);
  const TlSolveArrays solve = tl_divide_more_work(&work[85 * n]);
  const TlBlocks all = {blocks, (n / 8) * (n / 8), keeps, kept};
  const TlTree tree = {beyond, depths, path_ends, paths, strip_ends, strips};
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
  tl_multiply_paths(&tree, drives, of.P, of.S, solve.H);
  tl_factor_paths(&tree, solve.H, solve.L, solve.inverse_D, solve.qdd);
  tl_solve_outward(&tree, solve.L, solve.inverse_D, solve.qdd);
  tl_accelerate(parents, &solve, &of);
  tl_find_changes(up, &of);
  tl_negate(9 * n, of.P);
  tl_negate(12 * n, of.T);
  for (int32_t column = 0; column < TL_VELOCITIES; column += 8) {
    tl_fill_strip(&all, column, drives, rates, &of, solve.X);
    tl_solve_strip(
        &tree, column, solve.L, solve.inverse_D, solve.X, by_q, by_qd, inverse);
  }
}
