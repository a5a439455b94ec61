#pragma once
// Dynamics of a tree in one common frame, the base's: what belongs to links only adds
// up there, and vectors of joints stand side by side, one array a component,
// TL_PLACES apart, so that compilers make vector instructions of the loops. Every
// freedom has a place; of the six of a floating base the last stands for its link,
// the others have none. Rows are linear over angular. No branch on data.

#include <stdbool.h>

#include "ending_sizes.h"
#include "registers.h"

/// Constants of links in their own axes, ten arrays: mass, first moment (3), second
/// moment (xx, yy, zz, xy, xz, yz). Constants of joints, two arrays: how much of the
/// axis z each turns about, and how much it slides along.
///
/// Moves what belongs to links to the common frame: `S` gets the joints' axes (6),
/// and `body` the links' ten numbers, from their rotations `R` (9, row by row) and
/// origins `p` (3).
TL_INLINE void tl_place_links(const real* TL_RESTRICT links,
    const real* TL_RESTRICT joints, const real* TL_RESTRICT R,
    const real* TL_RESTRICT p, real* TL_RESTRICT S, real* TL_RESTRICT body) {
  const int32_t n = TL_PLACES;
  for (int32_t i = 0; i < TL_PLACES; ++i) {
    const real r0 = R[i], r1 = R[n + i], r2 = R[(2 * n) + i];
    const real r3 = R[(3 * n) + i], r4 = R[(4 * n) + i], r5 = R[(5 * n) + i];
    const real r6 = R[(6 * n) + i], r7 = R[(7 * n) + i], r8 = R[(8 * n) + i];
    const real px = p[i], py = p[n + i], pz = p[(2 * n) + i];
    const real turn = joints[i], slide = joints[n + i];
    const real wx = turn * r2, wy = turn * r5, wz = turn * r8;
    S[i] = (slide * r2) + ((py * wz) - (pz * wy));
    S[n + i] = (slide * r5) + ((pz * wx) - (px * wz));
    S[(2 * n) + i] = (slide * r8) + ((px * wy) - (py * wx));
    S[(3 * n) + i] = wx;
    S[(4 * n) + i] = wy;
    S[(5 * n) + i] = wz;
    const real m = links[i];
    const real lx = links[n + i], ly = links[(2 * n) + i], lz = links[(3 * n) + i];
    const real hx = ((r0 * lx) + (r1 * ly)) + (r2 * lz);
    const real hy = ((r3 * lx) + (r4 * ly)) + (r5 * lz);
    const real hz = ((r6 * lx) + (r7 * ly)) + (r8 * lz);
    body[i] = m;
    body[n + i] = hx + (m * px);
    body[(2 * n) + i] = hy + (m * py);
    body[(3 * n) + i] = hz + (m * pz);
    const real xx = links[(4 * n) + i], yy = links[(5 * n) + i];
    const real zz = links[(6 * n) + i], xy = links[(7 * n) + i];
    const real xz = links[(8 * n) + i], yz = links[(9 * n) + i];
    const real a0 = ((r0 * xx) + (r1 * xy)) + (r2 * xz);
    const real a1 = ((r0 * xy) + (r1 * yy)) + (r2 * yz);
    const real a2 = ((r0 * xz) + (r1 * yz)) + (r2 * zz);
    const real a3 = ((r3 * xx) + (r4 * xy)) + (r5 * xz);
    const real a4 = ((r3 * xy) + (r4 * yy)) + (r5 * yz);
    const real a5 = ((r3 * xz) + (r4 * yz)) + (r5 * zz);
    const real a6 = ((r6 * xx) + (r7 * xy)) + (r8 * xz);
    const real a7 = ((r6 * xy) + (r7 * yy)) + (r8 * yz);
    const real a8 = ((r6 * xz) + (r7 * yz)) + (r8 * zz);
    // p h^T + h p^T + m p p^T = p u^T + u p^T
    const real half = TL_REAL(0.5) * m;
    const real ux = hx + (half * px), uy = hy + (half * py), uz = hz + (half * pz);
    body[(4 * n) + i] = (((a0 * r0) + (a1 * r1)) + (a2 * r2)) + ((ux + ux) * px);
    body[(5 * n) + i] = (((a3 * r3) + (a4 * r4)) + (a5 * r5)) + ((uy + uy) * py);
    body[(6 * n) + i] = (((a6 * r6) + (a7 * r7)) + (a8 * r8)) + ((uz + uz) * pz);
    body[(7 * n) + i] =
        (((a0 * r3) + (a1 * r4)) + (a2 * r5)) + ((ux * py) + (uy * px));
    body[(8 * n) + i] =
        (((a0 * r6) + (a1 * r7)) + (a2 * r8)) + ((ux * pz) + (uz * px));
    body[(9 * n) + i] =
        (((a3 * r6) + (a4 * r7)) + (a5 * r8)) + ((uy * pz) + (uz * py));
  }
}

/// Adds to each link's `count` numbers, at most seven, those of everything beyond it.
/// `parents` has for each place that of the link before, -1 for none.
TL_INLINE TREELINE_IN_PLACE void tl_add_up(
    const int16_t* parents, int32_t count, real* body) {
  real sums[7];
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < count; ++k) {
    sums[k] = TL_ZERO;
  }
  for (int32_t i = TL_VELOCITIES - 1; i >= 0; --i) {
    const int32_t to = parents[i];
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < count; ++k) {
      sums[k] = body[(k * TL_PLACES) + i] + sums[k];
      body[(k * TL_PLACES) + i] = sums[k];
    }
    if (to != (i - 1)) {
      TREELINE_WRITTEN_OUT for (int32_t k = 0; k < count; ++k) {
        if (to >= 0) {
          body[(k * TL_PLACES) + to] = body[(k * TL_PLACES) + to] + sums[k];
        }
        sums[k] = TL_ZERO;
      }
    }
  }
}

/// The axes of a floating base's freedoms.
TL_INLINE void tl_place_base(real* S) {
  for (int32_t i = 0; i < 6; ++i) {
    for (int32_t k = 0; k < 6; ++k) {
      S[(k * TL_PLACES) + i] = (k == i) ? TL_ONE : TL_ZERO;
    }
  }
}

/// Gives all freedoms of a floating base the numbers of its link.
TL_INLINE void tl_share_base(int32_t count, real* body) {
  for (int32_t i = 0; i < 5; ++i) {
    for (int32_t k = 0; k < count; ++k) {
      body[(k * TL_PLACES) + i] = body[(k * TL_PLACES) + 5];
    }
  }
}

/// P = I S: momenta of everything beyond the joints at unit speeds of each.
TL_INLINE void tl_multiply_inertias(
    const real* TL_RESTRICT body, const real* TL_RESTRICT S, real* TL_RESTRICT P) {
  const int32_t n = TL_PLACES;
  for (int32_t i = 0; i < TL_PLACES; ++i) {
    const real m = body[i];
    const real hx = body[n + i], hy = body[(2 * n) + i], hz = body[(3 * n) + i];
    const real xx = body[(4 * n) + i], yy = body[(5 * n) + i];
    const real zz = body[(6 * n) + i], xy = body[(7 * n) + i];
    const real xz = body[(8 * n) + i], yz = body[(9 * n) + i];
    const real ux = S[i], uy = S[n + i], uz = S[(2 * n) + i];
    const real wx = S[(3 * n) + i], wy = S[(4 * n) + i], wz = S[(5 * n) + i];
    P[i] = (m * ux) + ((wy * hz) - (wz * hy));
    P[n + i] = (m * uy) + ((wz * hx) - (wx * hz));
    P[(2 * n) + i] = (m * uz) + ((wx * hy) - (wy * hx));
    P[(3 * n) + i] =
        ((((yy + zz) * wx) - (xy * wy)) - (xz * wz)) + ((hy * uz) - (hz * uy));
    P[(4 * n) + i] =
        ((((xx + zz) * wy) - (xy * wx)) - (yz * wz)) + ((hz * ux) - (hx * uz));
    P[(5 * n) + i] =
        ((((xx + yy) * wz) - (xz * wx)) - (yz * wy)) + ((hx * uy) - (hy * ux));
  }
}

/// Products of eight columns of `A` and eight of `X`, so many numbers long, as so
/// many rows. Where not everything carries everything, `keeps` lists for each row
/// where eight factors of 0 and 1 begin in `kept`; else it is null.
TL_INLINE TREELINE_IN_PLACE void tl_multiply_eight(const real* A, const real* X,
    int32_t length, const int16_t* keeps, const real* kept, int32_t rows,
    int32_t stride, real* to) {
  TlRegister x[9 * TL_REGISTERS];
  TREELINE_WRITTEN_OUT for (int32_t c = 0; c < length; ++c) {
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
      x[(c * TL_REGISTERS) + k] = tl_load(&X[(c * TL_PLACES) + (k * TL_WIDTH)]);
    }
  }
  for (int32_t i = 0; i < rows; ++i) {
    const real* const a = &A[i];
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
      TlRegister sum = a[0] * x[k];
      TREELINE_WRITTEN_OUT for (int32_t c = 1; c < length; ++c) {
        sum = sum + (a[c * TL_PLACES] * x[(c * TL_REGISTERS) + k]);
      }
      if (keeps != TL_NONE) {
        sum = sum * tl_load(&kept[keeps[i] + (k * TL_WIDTH)]);
      }
      tl_store(sum, &to[(i * stride) + (k * TL_WIDTH)]);
    }
  }
}

/// Zeros as so many rows of eight.
TL_INLINE void tl_clear_eight(int32_t rows, int32_t stride, real* to) {
  for (int32_t i = 0; i < rows; ++i) {
    for (int32_t j = 0; j < 8; ++j) {
      to[(i * stride) + j] = TL_ZERO;
    }
  }
}

/// Which blocks of eight rows and columns a matrix has: a row of three numbers each.
/// They are the first row, the first column, and where its rows begin in `keeps`, -1
/// where all entries count, -2 where all are 0. Blocks come from the right to the
/// left, then from above to below: what is written beyond the end of a row is written
/// again.
struct TlBlocks {
  const int16_t* list;
  int32_t count;
  const int16_t* keeps;
  const real* kept;
};
typedef struct TlBlocks TlBlocks;

/// Copies what is at and below the diagonal of a block of eight rows. Rows are read
/// and written whole, which is faster than parts of changing length.
TL_INLINE void tl_copy_below(
    const real* from, int32_t rows, int32_t stride, real* to) {
  for (int32_t i = 0; i < rows; ++i) {
    for (int32_t j = 0; j < 8; ++j) {
      const int32_t at = (i * stride) + j;
      to[at] = (j <= i) ? from[(8 * i) + j] : to[at];
    }
  }
}

/// A block of a matrix whose entries at and below the diagonal are products of
/// columns of `A` and `X`, so many numbers long, and above it of those of `B` and
/// `Y`, six long.
TL_INLINE TREELINE_IN_PLACE void tl_multiply_block(const TlBlocks* blocks, int32_t at,
    const real* A, const real* X, int32_t length, const real* B, const real* Y,
    int32_t rows, int32_t stride, real* to) {
  const int32_t row = blocks->list[3 * at];
  const int32_t column = blocks->list[(3 * at) + 1];
  const int32_t kind = blocks->list[(3 * at) + 2];
  const int16_t* const keeps = (kind >= 0) ? &blocks->keeps[kind] : TL_NONE;
  if (kind == -2) {
    tl_clear_eight(rows, stride, to);
  } else if (row > column) {
    tl_multiply_eight(
        &A[row], &X[column], length, keeps, blocks->kept, rows, stride, to);
  } else {
    tl_multiply_eight(&B[row], &Y[column], 6, keeps, blocks->kept, rows, stride, to);
  }
  if (row == column) {
    real below[64];
    tl_multiply_eight(
        &A[row], &X[column], length, keeps, blocks->kept, rows, 8, below);
    tl_copy_below(below, rows, stride, to);
  }
}

/// All blocks of such a matrix.
TL_INLINE TREELINE_IN_PLACE void tl_multiply_blocks(const TlBlocks* blocks,
    const real* A, const real* X, int32_t length, const real* B, const real* Y,
    real* to) {
  for (int32_t e = 0; e < blocks->count; ++e) {
    const int32_t row = blocks->list[3 * e];
    const int32_t column = blocks->list[(3 * e) + 1];
    const int32_t left = TL_VELOCITIES - row;
    const int32_t rows = (left < 8) ? left : 8;
    const bool last = (row == column) && (left < 8);
    real end[64];  // the last block would be written beyond the end
    real* const block = last ? end : &to[(row * TL_VELOCITIES) + column];
    const int32_t stride = last ? 8 : TL_VELOCITIES;
    tl_multiply_block(blocks, e, A, X, length, B, Y, rows, stride, block);
    if (last) {
      for (int32_t i = 0; i < rows; ++i) {
        for (int32_t j = 0; j < rows; ++j) {
          to[((row + i) * TL_VELOCITIES) + column + j] = end[(8 * i) + j];
        }
      }
    }
  }
}

/// M = S^T I S of composite bodies (RBDA table 6.2). `rotors` are added to the
/// diagonal.
TL_INLINE void tl_mass_in_common_frame(const real* links, const real* joints,
    const real* rotors, const int16_t* parents, const int16_t* blocks,
    const int16_t* keeps, const real* kept, const real* R, const real* p, real* work,
    real* M) {
  real* const S = work;
  real* const P = &work[6 * TL_PLACES];
  real* const body = &work[12 * TL_PLACES];
  const TlBlocks all = {blocks, (TL_PLACES / 8) * (TL_PLACES / 8), keeps, kept};
  tl_place_links(links, joints, R, p, S, body);
  tl_add_up(parents, 5, body);
  tl_add_up(parents, 5, &body[5 * TL_PLACES]);
  if (TL_FLOATS) {
    tl_place_base(S);
    tl_share_base(10, body);
  }
  tl_multiply_inertias(body, S, P);
  tl_multiply_blocks(&all, P, S, 6, S, P, M);
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    const int32_t at = i * (TL_VELOCITIES + 1);
    M[at] = M[at] + rotors[i];
  }
}
