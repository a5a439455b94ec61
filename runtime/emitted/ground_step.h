#pragma once
// One step of a robot on the ground z < 0: it flies, impulses stop the points that
// flew into the ground, or would next, and what they change of the velocities acts
// for all of the step.

#include "ground_blow.h"

/// The points in the ground after a flight, and with them what the fastest of these
/// would reach in another step, and what was so near before.
TL_FUNCTION void tl_touches_after(const TlGroundPose* at, const real* heights,
    const real* qd, real dt, TlGroundTouches* found) {
  tl_find_touches(at, heights, qd, TL_ZERO, TL_ZERO, found);
  real fastest = TL_ZERO;
  for (int32_t c = 0; c < found->count; ++c) {
    real v[3];
    tl_velocity_of(at, qd, &found->list[c], &v[0]);
    fastest = (-v[2] > fastest) ? -v[2] : fastest;
  }
  if ((found->left_out == 0) && (fastest > TL_ZERO)) {
    const real touching = TL_REAL(1e-6);  // m
    tl_find_touches(at, heights, qd, tl_larger(touching, fastest * dt), dt, found);
  }
}

/// Moves the coordinates by a change of velocities for `seconds`, or for as long as
/// the energy stays below `most`. Returns the energy.
TL_FUNCTION real tl_push_out(real most, TlVelocitiesIn dqd, real seconds,
    TlVelocitiesIn qd, TlCoordinatesOut q) {
  const real shorter = TL_REAL(0.999999);  // rounding does not refuse the next turn
  const real least = tl_find_energy(q, qd);
  real struck[TL_GROUND_COORDINATES];
  for (int32_t i = 0; i < TL_GROUND_COORDINATES; ++i) {
    struck[i] = q[i];
  }
  real energy = least;
  for (int32_t turn = 0; turn < 4; ++turn) {
    tl_ground_move(dqd, seconds, q);
    energy = tl_find_energy(q, qd);
    if (energy <= most) {
      return energy;
    }
    for (int32_t i = 0; i < TL_GROUND_COORDINATES; ++i) {
      q[i] = struck[i];
    }
    seconds *= shorter * tl_larger(TL_ZERO, (most - least) / (energy - least));
  }
  return least;
}

/// Stops the points that flew into the ground, where any did.
TL_FUNCTION void tl_settle(const TlGround* ground, real dt, const real* heights,
    real start_energy, TlCoordinatesOut q, TlVelocitiesOut qd, TlGroundMemory* memory,
    TlGroundReport* report) {
  TlGroundPose at;
  TlGroundTouches found;
  TlGroundBlow blow;
  tl_find_dynamics(q, &at);
  tl_touches_after(&at, heights, qd, dt, &found);
  report->left_out = found.left_out;
  if (found.count > 0) {
    const real most = tl_larger(start_energy, tl_find_energy(q, qd));
    tl_strike(ground, &at, dt, qd, &found, memory, &blow, report);
    for (int32_t i = 0; i < TL_GROUND_VELOCITIES; ++i) {
      qd[i] += blow.dqd[i];
    }
    report->energy = tl_push_out(most, blow.dqd, dt, qd, q) - most;
  }
}

TL_INLINE void tl_begin_report(TlGroundReport* report) {
  report->contacts = 0;
  report->converged = 1;
  report->left_out = 0;
  report->miss = TL_ZERO;
  report->energy = TL_ZERO;
  for (int32_t i = 0; i < 3; ++i) {
    report->impulse[i] = TL_ZERO;
  }
}

/// One step of `dt` seconds.
TL_FUNCTION void tl_advance(const TlGround* ground, real dt, const real* tau, real* q,
    real* qd, TlGroundMemory* memory, TlGroundReport* report) {
  real from[TL_GROUND_COORDINATES];
  real to[TL_GROUND_COORDINATES];
  real before[TL_GROUND_VELOCITIES];
  real after[TL_GROUND_VELOCITIES];
  real forces[TL_GROUND_VELOCITIES];
  real heights[4 * TL_GROUND_GROUPS];
  for (int32_t i = 0; i < TL_GROUND_COORDINATES; ++i) {
    from[i] = q[i];
    to[i] = q[i];
  }
  for (int32_t i = 0; i < TL_GROUND_VELOCITIES; ++i) {
    before[i] = qd[i];
    forces[i] = tau[i];
  }
  tl_begin_report(report);
  tl_find_flight(from, before, forces, after);
  for (int32_t i = 0; i < TL_GROUND_VELOCITIES; ++i) {
    after[i] = before[i] + (dt * after[i]);
  }
  tl_ground_move(after, dt, to);
  tl_find_heights(to, heights);
  if (tl_may_any_touch(heights, TL_ZERO)) {
    const real energy = tl_find_energy(from, before);
    tl_settle(ground, dt, heights, energy, to, after, memory, report);
  }
  for (int32_t i = 0; i < TL_GROUND_COORDINATES; ++i) {
    q[i] = to[i];
  }
  for (int32_t i = 0; i < TL_GROUND_VELOCITIES; ++i) {
    qd[i] = after[i];
  }
}
