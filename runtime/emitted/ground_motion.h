#pragma once
// Coordinates moved on by constant velocities.

#include <stdbool.h>
#include <stdint.h>

#include "ground_robot.h"

/// The quaternion of a rotation vector, x y z w: exp(turn / 2).
TL_FUNCTION void tl_quaternion_of_turn(const real* turn, real* q) {
  const real half = TL_HALF *
      tl_square_root((turn[0] * turn[0]) + (turn[1] * turn[1]) + (turn[2] * turn[2]));
  real sine = TL_ZERO;
  real cosine = TL_ONE;
  tl_sin_cos_of(half, &sine, &cosine);
  const real share = TL_HALF * ((half > TL_ZERO) ? (sine / half) : TL_ONE);
  for (int32_t i = 0; i < 3; ++i) {
    q[i] = share * turn[i];
  }
  q[3] = cosine;
}

/// a b: the rotation b followed by a.
TL_INLINE void tl_quaternion_product(const real* a, const real* b, real* product) {
  product[0] = (a[3] * b[0]) + (b[3] * a[0]) + ((a[1] * b[2]) - (a[2] * b[1]));
  product[1] = (a[3] * b[1]) + (b[3] * a[1]) + ((a[2] * b[0]) - (a[0] * b[2]));
  product[2] = (a[3] * b[2]) + (b[3] * a[2]) + ((a[0] * b[1]) - (a[1] * b[0]));
  product[3] = (a[3] * b[3]) - ((a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]));
}

/// Adds v, turned by a quaternion, to x.
TL_INLINE void tl_add_turned(const real* q, const real* v, real* x) {
  real across[3];
  across[0] = (q[1] * v[2]) - (q[2] * v[1]) + (q[3] * v[0]);
  across[1] = (q[2] * v[0]) - (q[0] * v[2]) + (q[3] * v[1]);
  across[2] = (q[0] * v[1]) - (q[1] * v[0]) + (q[3] * v[2]);
  x[0] += v[0] + (TL_TWO * ((q[1] * across[2]) - (q[2] * across[1])));
  x[1] += v[1] + (TL_TWO * ((q[2] * across[0]) - (q[0] * across[2])));
  x[2] += v[2] + (TL_TWO * ((q[0] * across[1]) - (q[1] * across[0])));
}

/// A joint with a quaternion of any length, for `dt` seconds: turns by exp(w dt), and
/// moves in the axes halfway through the turn.
TL_FUNCTION void tl_move_freely(const real* qd, real dt, bool slides, real* q) {
  real* const turned = slides ? &q[3] : &q[0];
  const real* const w = slides ? &qd[3] : &qd[0];
  const real length = tl_square_root((turned[0] * turned[0]) +
      (turned[1] * turned[1]) + (turned[2] * turned[2]) + (turned[3] * turned[3]));
  real half[3];
  real by[4];
  real middle[4];
  for (int32_t i = 0; i < 4; ++i) {
    turned[i] /= length;
  }
  for (int32_t i = 0; i < 3; ++i) {
    half[i] = TL_HALF * dt * w[i];
  }
  tl_quaternion_of_turn(&half[0], &by[0]);
  tl_quaternion_product(turned, &by[0], &middle[0]);
  if (slides) {
    const real way[3] = {dt * qd[0], dt * qd[1], dt * qd[2]};
    tl_add_turned(&middle[0], &way[0], q);
  }
  tl_quaternion_product(&middle[0], &by[0], turned);
}

/// Moves the coordinates for `dt` seconds with constant velocities.
TL_FUNCTION void tl_ground_move(const real* qd, real dt, real* q) {
  int32_t at = 0;
  int32_t v = 0;
  for (int32_t joint = 0; joint < TL_GROUND_TURNS; ++joint) {
    const int32_t* const place = &TL_GROUND_QUATERNIONS[3 * joint];
    const bool slides = place[2] == 1;
    for (; at < place[0]; ++at) {
      q[at] += dt * qd[v];
      ++v;
    }
    tl_move_freely(&qd[v], dt, slides, &q[at]);
    at += slides ? 7 : 4;
    v += slides ? 6 : 3;
  }
  for (; at < TL_GROUND_COORDINATES; ++at) {
    q[at] += dt * qd[v];
    ++v;
  }
}
