#pragma once
// Derivatives of joint forces of a tree in one common frame (Carpentier & Mansard
// 2018; Singh, Russell & Wensing 2022). Numbers of links add up: inertia (10), twice
// the linear momentum (3), the matrix K (9) and the wrench (6). K w + w x 2 p is the
// change of the wrench with what turns at w beside the steady one.

#include "common_frame.h"

/// Arrays of the work space, each of some components of all freedoms.
struct TlMotionArrays {
  real* S;  ///< axes of joints (6)
  real* P;  ///< momenta at unit speeds (6), and Q behind them (3): forces by turning
  real* by_q;  ///< changes of acceleration (6) and of turning (3) with displacements
  real* by_qd;  ///< the same with velocities
  real*
      T;  ///< changes of the wrench that a joint passes on, with its displacement (6)
  real* U;  ///< with its velocity (6)
  real* v;  ///< velocities of links (6)
  real* a;  ///< accelerations of links, against gravity (6)
  real* body;  ///< numbers of links (28)
};
typedef struct TlMotionArrays TlMotionArrays;

TL_INLINE TlMotionArrays tl_divide_work(real* work) {
  const int32_t n = TL_PLACES;
  const TlMotionArrays arrays = {work, &work[6 * n], &work[15 * n], &work[24 * n],
      &work[33 * n], &work[39 * n], &work[45 * n], &work[51 * n], &work[57 * n]};
  return arrays;
}

/// Gives the freedoms of a floating base six numbers of its link.
TL_INLINE void tl_share_motion(const real* motion, real* of) {
  for (int32_t k = 0; k < 6; ++k) {
    for (int32_t i = 0; i < 6; ++i) {
      of[(k * TL_PLACES) + i] = motion[k];
    }
  }
}

/// Velocities of all links, from those of joints.
TL_INLINE void tl_find_velocities(
    const int16_t* parents, const real* S, const real* qd, real* v) {
  if (TL_FLOATS) {
    tl_share_motion(qd, v);
  }
  for (int32_t i = TL_FLOATS ? 6 : 0; i < TL_VELOCITIES; ++i) {
    const int32_t from = parents[i];
    for (int32_t k = 0; k < (6 * TL_PLACES); k += TL_PLACES) {
      const real own = S[k + i] * qd[i];
      v[k + i] = (from >= 0) ? (v[k + from] + own) : own;
    }
  }
}

/// to = v x x: the change of what moves with v.
TL_INLINE void tl_cross_motions(
    const real* TL_RESTRICT v, const real* TL_RESTRICT x, real* TL_RESTRICT to) {
  const int32_t n = TL_PLACES;
  for (int32_t i = 0; i < TL_PLACES; ++i) {
    const real vx = v[i], vy = v[n + i], vz = v[(2 * n) + i];
    const real wx = v[(3 * n) + i], wy = v[(4 * n) + i], wz = v[(5 * n) + i];
    const real ux = x[i], uy = x[n + i], uz = x[(2 * n) + i];
    const real sx = x[(3 * n) + i], sy = x[(4 * n) + i], sz = x[(5 * n) + i];
    to[i] = ((wy * uz) - (wz * uy)) + ((vy * sz) - (vz * sy));
    to[n + i] = ((wz * ux) - (wx * uz)) + ((vz * sx) - (vx * sz));
    to[(2 * n) + i] = ((wx * uy) - (wy * ux)) + ((vx * sy) - (vy * sx));
    to[(3 * n) + i] = (wy * sz) - (wz * sy);
    to[(4 * n) + i] = (wz * sx) - (wx * sz);
    to[(5 * n) + i] = (wx * sy) - (wy * sx);
  }
}

/// Accelerations of all links against gravity, `up` at the base. `turned` is v x S.
TL_INLINE void tl_find_accelerations(const int16_t* parents, const real* S,
    const real* turned, const real* qd, const real* qdd, const real* up, real* a) {
  const real at_base[6] = {up[0], up[1], up[2], TL_ZERO, TL_ZERO, TL_ZERO};
  if (TL_FLOATS) {
    real motion[6];
    for (int32_t k = 0; k < 6; ++k) {
      motion[k] = at_base[k] + qdd[k];
    }
    tl_share_motion(motion, a);
  }
  for (int32_t i = TL_FLOATS ? 6 : 0; i < TL_VELOCITIES; ++i) {
    const int32_t from = parents[i];
    for (int32_t k = 0; k < 6; ++k) {
      const int32_t at = k * TL_PLACES;
      const real before = (from >= 0) ? a[at + from] : at_base[k];
      a[at + i] = (before + (S[at + i] * qdd[i])) + (turned[at + i] * qd[i]);
    }
  }
}

/// Numbers of links that depend on motion, behind the ten of inertia. `momentum` is
/// work space.
TL_INLINE void tl_find_wrenches(const real* TL_RESTRICT v, const real* TL_RESTRICT a,
    const real* TL_RESTRICT inertia, real* TL_RESTRICT momentum,
    real* TL_RESTRICT to) {
  const int32_t n = TL_PLACES;
  real* const wrench = &to[12 * n];
  tl_multiply_inertias(inertia, v, momentum);
  tl_multiply_inertias(inertia, a, wrench);
  for (int32_t i = 0; i < TL_PLACES; ++i) {
    const real hx = inertia[n + i], hy = inertia[(2 * n) + i],
               hz = inertia[(3 * n) + i];
    const real xx = inertia[(4 * n) + i], yy = inertia[(5 * n) + i];
    const real zz = inertia[(6 * n) + i], xy = inertia[(7 * n) + i];
    const real xz = inertia[(8 * n) + i], yz = inertia[(9 * n) + i];
    const real vx = v[i], vy = v[n + i], vz = v[(2 * n) + i];
    const real wx = v[(3 * n) + i], wy = v[(4 * n) + i], wz = v[(5 * n) + i];
    const real px = momentum[i], py = momentum[n + i], pz = momentum[(2 * n) + i];
    const real lx = momentum[(3 * n) + i], ly = momentum[(4 * n) + i];
    const real lz = momentum[(5 * n) + i];
    to[i] = px + px;
    to[n + i] = py + py;
    to[(2 * n) + i] = pz + pz;
    // K / 2 = (h.v) 1 - v h^T - [w] Sigma
    const real hv = ((hx * vx) + (hy * vy)) + (hz * vz);
    const real k0 = (hv - (vx * hx)) - ((wy * xz) - (wz * xy));
    const real k1 = (wz * yy) - (wy * yz) - (vx * hy);
    const real k2 = (wz * yz) - (wy * zz) - (vx * hz);
    const real k3 = (wx * xz) - (wz * xx) - (vy * hx);
    const real k4 = (hv - (vy * hy)) - ((wz * xy) - (wx * yz));
    const real k5 = (wx * zz) - (wz * xz) - (vy * hz);
    const real k6 = (wy * xx) - (wx * xy) - (vz * hx);
    const real k7 = (wy * xy) - (wx * yy) - (vz * hy);
    const real k8 = (hv - (vz * hz)) - ((wx * yz) - (wy * xz));
    to[(3 * n) + i] = k0 + k0;
    to[(4 * n) + i] = k1 + k1;
    to[(5 * n) + i] = k2 + k2;
    to[(6 * n) + i] = k3 + k3;
    to[(7 * n) + i] = k4 + k4;
    to[(8 * n) + i] = k5 + k5;
    to[(9 * n) + i] = k6 + k6;
    to[(10 * n) + i] = k7 + k7;
    to[(11 * n) + i] = k8 + k8;
    wrench[i] = wrench[i] + ((wy * pz) - (wz * py));
    wrench[n + i] = wrench[n + i] + ((wz * px) - (wx * pz));
    wrench[(2 * n) + i] = wrench[(2 * n) + i] + ((wx * py) - (wy * px));
    wrench[(3 * n) + i] =
        (wrench[(3 * n) + i] + ((wy * lz) - (wz * ly))) + ((vy * pz) - (vz * py));
    wrench[(4 * n) + i] =
        (wrench[(4 * n) + i] + ((wz * lx) - (wx * lz))) + ((vz * px) - (vx * pz));
    wrench[(5 * n) + i] =
        (wrench[(5 * n) + i] + ((wx * ly) - (wy * lx))) + ((vx * py) - (vy * px));
  }
}

/// Numbers of everything beyond each joint.
TL_INLINE void tl_add_up_links(const int16_t* parents, const TlMotionArrays* of) {
  tl_find_wrenches(of->v, of->a, of->body, of->P, &of->body[10 * TL_PLACES]);
  for (int32_t k = 0; k < 28; k += 7) {
    tl_add_up(parents, 7, &of->body[k * TL_PLACES]);
  }
  if (TL_FLOATS) {
    tl_share_base(28, of->body);
  }
}

/// Q = K^T S_turn + 2 p x S_slide.
TL_INLINE void tl_find_turning_forces(
    const real* TL_RESTRICT steady, const real* TL_RESTRICT S, real* TL_RESTRICT Q) {
  const int32_t n = TL_PLACES;
  for (int32_t i = 0; i < TL_PLACES; ++i) {
    const real px = steady[i], py = steady[n + i], pz = steady[(2 * n) + i];
    const real ux = S[i], uy = S[n + i], uz = S[(2 * n) + i];
    const real wx = S[(3 * n) + i], wy = S[(4 * n) + i], wz = S[(5 * n) + i];
    Q[i] = (steady[(3 * n) + i] * wx) + (steady[(6 * n) + i] * wy) +
        (steady[(9 * n) + i] * wz) + ((py * uz) - (pz * uy));
    Q[n + i] = (steady[(4 * n) + i] * wx) + (steady[(7 * n) + i] * wy) +
        (steady[(10 * n) + i] * wz) + ((pz * ux) - (px * uz));
    Q[(2 * n) + i] = (steady[(5 * n) + i] * wx) + (steady[(8 * n) + i] * wy) +
        (steady[(11 * n) + i] * wz) + ((px * uy) - (py * ux));
  }
}

/// Adds to `wrench` what turning does: w x 2 p, K w.
TL_INLINE void tl_add_turning(const real* TL_RESTRICT steady,
    const real* TL_RESTRICT w, real* TL_RESTRICT wrench) {
  const int32_t n = TL_PLACES;
  for (int32_t i = 0; i < TL_PLACES; ++i) {
    const real px = steady[i], py = steady[n + i], pz = steady[(2 * n) + i];
    const real wx = w[i], wy = w[n + i], wz = w[(2 * n) + i];
    wrench[i] = wrench[i] + ((wy * pz) - (wz * py));
    wrench[n + i] = wrench[n + i] + ((wz * px) - (wx * pz));
    wrench[(2 * n) + i] = wrench[(2 * n) + i] + ((wx * py) - (wy * px));
    wrench[(3 * n) + i] = wrench[(3 * n) + i] +
        ((steady[(3 * n) + i] * wx) + (steady[(4 * n) + i] * wy) +
            (steady[(5 * n) + i] * wz));
    wrench[(4 * n) + i] = wrench[(4 * n) + i] +
        ((steady[(6 * n) + i] * wx) + (steady[(7 * n) + i] * wy) +
            (steady[(8 * n) + i] * wz));
    wrench[(5 * n) + i] = wrench[(5 * n) + i] +
        ((steady[(9 * n) + i] * wx) + (steady[(10 * n) + i] * wy) +
            (steady[(11 * n) + i] * wz));
  }
}

/// Adds to `wrench` that of everything beyond a joint, which moves with it, from
/// place `begin` on: the freedoms of a floating base move their own axes, too.
TL_INLINE void tl_move_wrenches(const real* TL_RESTRICT S,
    const real* TL_RESTRICT force, int32_t begin, real* TL_RESTRICT wrench) {
  const int32_t n = TL_PLACES;
  for (int32_t i = begin; i < TL_PLACES; ++i) {
    const real fx = force[i], fy = force[n + i], fz = force[(2 * n) + i];
    const real nx = force[(3 * n) + i], ny = force[(4 * n) + i],
               nz = force[(5 * n) + i];
    const real ux = S[i], uy = S[n + i], uz = S[(2 * n) + i];
    const real wx = S[(3 * n) + i], wy = S[(4 * n) + i], wz = S[(5 * n) + i];
    wrench[i] = wrench[i] + ((wy * fz) - (wz * fy));
    wrench[n + i] = wrench[n + i] + ((wz * fx) - (wx * fz));
    wrench[(2 * n) + i] = wrench[(2 * n) + i] + ((wx * fy) - (wy * fx));
    wrench[(3 * n) + i] =
        wrench[(3 * n) + i] + (((wy * nz) - (wz * ny)) + ((uy * fz) - (uz * fy)));
    wrench[(4 * n) + i] =
        wrench[(4 * n) + i] + (((wz * nx) - (wx * nz)) + ((uz * fx) - (ux * fz)));
    wrench[(5 * n) + i] =
        wrench[(5 * n) + i] + (((wx * ny) - (wy * nx)) + ((ux * fy) - (uy * fx)));
  }
}

/// Axes, inertias and velocities. Of v x S, by_qd gets all, and T what changes axes
/// before the joint moves, which is 0 for a floating base.
TL_INLINE void tl_begin_motion(const real* links, const real* joints,
    const int16_t* parents, const real* R, const real* p, const real* qd,
    const TlMotionArrays* of) {
  tl_place_links(links, joints, R, p, of->S, of->body);
  if (TL_FLOATS) {
    tl_place_base(of->S);
  }
  for (int32_t k = 0; k < (12 * TL_PLACES); ++k) {
    of->v[k] = TL_ZERO;  // and a, at places that stand for nothing
  }
  tl_find_velocities(parents, of->S, qd, of->v);
  tl_cross_motions(of->v, of->S, of->by_qd);
  for (int32_t k = 0; k < (6 * TL_PLACES); ++k) {
    of->T[k] = of->by_qd[k];
  }
  if (TL_FLOATS) {
    const real none[6] = {TL_ZERO, TL_ZERO, TL_ZERO, TL_ZERO, TL_ZERO, TL_ZERO};
    tl_share_motion(none, of->T);
  }
}

/// Changes of motion beyond each joint with its displacement and velocity, from the
/// velocities' own changes in T, and the changes of wrenches.
TL_INLINE void tl_find_changes(const real* up, const TlMotionArrays* of) {
  const int32_t n = TL_PLACES;
  const real* const steady = &of->body[10 * n];
  if (TL_FLOATS) {
    const real before[6] = {up[0], up[1], up[2], TL_ZERO, TL_ZERO, TL_ZERO};
    tl_share_motion(before, of->a);
  }
  tl_cross_motions(of->a, of->S, of->by_q);
  tl_cross_motions(of->v, of->T, of->U);
  for (int32_t k = 0; k < (6 * TL_PLACES); ++k) {
    of->by_q[k] = of->by_q[k] + of->U[k];
    of->by_qd[k] = of->by_qd[k] + of->T[k];
  }
  for (int32_t k = 0; k < (3 * TL_PLACES); ++k) {
    of->by_q[(6 * n) + k] = of->T[(3 * n) + k];
    of->by_qd[(6 * n) + k] = of->S[(3 * n) + k];
  }
  tl_multiply_inertias(of->body, of->S, of->P);
  tl_find_turning_forces(steady, of->S, &of->P[6 * n]);
  tl_multiply_inertias(of->body, of->by_q, of->T);
  tl_add_turning(steady, &of->by_q[6 * n], of->T);
  tl_move_wrenches(of->S, &of->body[22 * n], TL_FLOATS ? 6 : 0, of->T);
  tl_multiply_inertias(of->body, of->by_qd, of->U);
  tl_add_turning(steady, &of->by_qd[6 * n], of->U);
}

/// Derivatives of joint forces with respect to displacements, velocities and
/// accelerations. `rates` has qd, qdd, slopes of friction and, three numbers, the
/// acceleration that stands for gravity, up; `drives` what rotors add to the diagonal
/// of M and springs to that of the first.
TL_INLINE void tl_force_derivatives(const real* links, const real* joints,
    const real* drives, const int16_t* parents, const int16_t* blocks,
    const int16_t* keeps, const real* kept, const real* R, const real* p,
    const real* rates, real* work, real* by_q, real* by_qd, real* M) {
  const TlMotionArrays of = tl_divide_work(work);
  const TlBlocks all = {blocks, (TL_PLACES / 8) * (TL_PLACES / 8), keeps, kept};
  const real* const up = &rates[3 * TL_VELOCITIES];
  tl_begin_motion(links, joints, parents, R, p, rates, &of);
  tl_find_accelerations(parents, of.S, of.T, rates, &rates[TL_VELOCITIES], up, of.a);
  tl_add_up_links(parents, &of);
  tl_find_changes(up, &of);
  tl_multiply_blocks(&all, of.P, of.S, 6, of.S, of.P, M);
  tl_multiply_blocks(&all, of.P, of.by_q, 9, of.S, of.T, by_q);
  tl_multiply_blocks(&all, of.P, of.by_qd, 9, of.S, of.U, by_qd);
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    const int32_t at = i * (TL_VELOCITIES + 1);
    M[at] = M[at] + drives[i];
    by_q[at] = by_q[at] + drives[TL_VELOCITIES + i];
    by_qd[at] = by_qd[at] + rates[(2 * TL_VELOCITIES) + i];
  }
}
