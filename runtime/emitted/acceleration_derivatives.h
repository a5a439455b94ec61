#pragma once
// Derivatives of accelerations of a tree in one common frame: those of joint forces
// at the accelerations that result, solved for by M = L^T D L (RBDA section 6.5).

#include "force_derivatives.h"
#include "solve_columns.h"

/// to -= a x, for so many numbers and as many more as make a multiple of eight.
TL_INLINE TREELINE_IN_PLACE void tl_subtract_places(
    int32_t count, real a, const real* x, real* to) {
  for (int32_t j = 0; j < count; j += 8) {
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
      const int32_t at = j + (k * TL_WIDTH);
      tl_store(tl_load(&to[at]) - (a * tl_load(&x[at])), &to[at]);
    }
  }
}

/// Factors M = L^T D L, n x n, into rows of TL_PLACES. `ends` and `entries` list for
/// each row what carries it, see tl_subtract_entries.
TL_INLINE void tl_factor_tree(const int16_t* ends, const int16_t* entries,
    const real* TL_RESTRICT M, real* TL_RESTRICT L, real* TL_RESTRICT inverse_D) {
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    real* const row = &L[i * TL_PLACES];
    for (int32_t j = TL_VELOCITIES; j < TL_PLACES; ++j) {
      row[j] = TL_ZERO;
    }
    for (int32_t j = 0; j < TL_VELOCITIES; ++j) {
      row[j] = M[(i * TL_VELOCITIES) + j];
    }
  }
  for (int32_t k = TL_VELOCITIES - 1; k >= 0; --k) {
    real* const row = &L[k * TL_PLACES];
    const int32_t begin = (k > 0) ? ends[k - 1] : 0;
    inverse_D[k] = TL_ONE / row[k];
    for (int32_t e = ends[k] - 1; e >= begin; --e) {
      const int32_t i = entries[2 * e];
      const real factor = row[i] * inverse_D[k];
      tl_subtract_places(i + 1, factor, row, &L[i * TL_PLACES]);
      row[i] = factor;
    }
  }
}

/// Solves L^T D L x = b in place.
TL_INLINE void tl_solve_tree(const int16_t* ends, const int16_t* entries,
    const real* L, const real* inverse_D, real* x) {
  for (int32_t k = TL_VELOCITIES - 1; k >= 0; --k) {
    const int32_t begin = (k > 0) ? ends[k - 1] : 0;
    for (int32_t e = begin; e < ends[k]; ++e) {
      const int32_t i = entries[2 * e];
      x[i] = x[i] - (L[(k * TL_PLACES) + i] * x[k]);
    }
  }
  for (int32_t k = 0; k < TL_VELOCITIES; ++k) {
    const int32_t begin = (k > 0) ? ends[k - 1] : 0;
    x[k] = x[k] * inverse_D[k];
    for (int32_t e = begin; e < ends[k]; ++e) {
      x[k] = x[k] - (L[(k * TL_PLACES) + entries[2 * e]] * x[entries[2 * e]]);
    }
  }
}

/// Adds to the motion of links that accelerations of joints make, and to wrenches
/// what it takes. `own` has the ten numbers of each link alone; `more` is work space.
TL_INLINE void tl_accelerate(const int16_t* parents, const real* own, const real* qdd,
    real* more, const TlMotionArrays* of) {
  real* const wrench = &more[6 * TL_PLACES];
  real* const force = &of->body[22 * TL_PLACES];
  for (int32_t k = 0; k < (6 * TL_PLACES); ++k) {
    more[k] = TL_ZERO;
  }
  tl_find_velocities(parents, of->S, qdd, more);
  tl_multiply_inertias(own, more, wrench);
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

/// Derivatives of accelerations with respect to displacements, velocities and joint
/// forces. `rates` has qd, joint forces less friction and springs, slopes of friction
/// and, three numbers, the acceleration that stands for gravity, up; `drives` what
/// rotors add to the diagonal of M, and stiffnesses. `above` and `below` are those of
/// tl_solve_columns, with factors in rows of TL_PLACES.
TL_INLINE void tl_acceleration_derivatives(const real* links, const real* joints,
    const real* drives, const int16_t* parents, const int16_t* blocks,
    const int16_t* keeps, const real* kept, const int16_t* above_ends,
    const int16_t* above, const int16_t* below_ends, const int16_t* below,
    const real* R, const real* p, const real* rates, real* work, real* by_q,
    real* by_qd, real* inverse) {
  const int32_t n = TL_PLACES;
  const TlMotionArrays of = tl_divide_work(work);
  real* const own = &work[85 * n];
  real* const more = &work[95 * n];
  real* const qdd = &work[107 * n];
  real* const inverse_D = &work[108 * n];
  real* const L = &work[109 * n];
  real* const X = &work[(109 + TL_VELOCITIES) * n];
  const TlBlocks all = {blocks, (n / 8) * (n / 8), keeps, kept};
  const real* const up = &rates[3 * TL_VELOCITIES];
  tl_begin_motion(links, joints, parents, R, p, rates, &of);
  for (int32_t k = 0; k < (10 * n); ++k) {
    own[k] = of.body[k];
  }
  for (int32_t i = 0; i < n; ++i) {
    qdd[i] = TL_ZERO;
  }
  tl_find_accelerations(parents, of.S, of.T, rates, qdd, up, of.a);
  tl_add_up_links(parents, &of);
  tl_find_rest(&rates[TL_VELOCITIES], &of, qdd);
  tl_multiply_inertias(of.body, of.S, of.P);
  tl_multiply_blocks(&all, of.P, of.S, 6, of.S, of.P, inverse);
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    const int32_t at = i * (TL_VELOCITIES + 1);
    inverse[at] = inverse[at] + drives[i];
  }
  tl_factor_tree(below_ends, below, inverse, L, inverse_D);
  tl_solve_tree(below_ends, below, L, inverse_D, qdd);
  tl_accelerate(parents, own, qdd, more, &of);
  tl_find_changes(up, &of);
  tl_negate(9 * n, of.P);
  tl_negate(12 * n, of.T);
  tl_multiply_blocks(&all, of.P, of.by_q, 9, of.S, of.T, by_q);
  tl_multiply_blocks(&all, of.P, of.by_qd, 9, of.S, of.U, by_qd);
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    const int32_t at = i * (TL_VELOCITIES + 1);
    by_q[at] = by_q[at] - drives[TL_VELOCITIES + i];
    by_qd[at] = by_qd[at] - rates[(2 * TL_VELOCITIES) + i];
  }
  tl_solve_columns(
      above_ends, above, below_ends, below, L, inverse_D, X, by_q, by_qd, inverse);
}
