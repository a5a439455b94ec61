#pragma once
// Points of a robot's shapes that are in the ground z < 0 or near it: of links that
// move as one at most four, the lowest and those that span most.

#include "ground_paths.h"

/// A point near the ground; `arm` leads to it from the origin of TlGroundPose.
struct TlGroundTouch {
  int32_t id;  // of four for each point of a shape
  int32_t group;
  real arm[3];
  real depth;  // m; negative above the ground
};
typedef struct TlGroundTouch TlGroundTouch;

/// Points, the deepest first.
struct TlGroundTouches {
  TlGroundTouch list[TL_CONTACTS];
  int32_t count;
  int32_t left_out;  // in the ground beyond the most that count
};
typedef struct TlGroundTouches TlGroundTouches;

/// Points of one group below a margin.
struct TlGroundGroup {
  TlGroundTouch list[TL_GROUND_MOST_POINTS];
  int32_t count;
};
typedef struct TlGroundGroup TlGroundGroup;

/// What counts as near the ground: what is lower than a margin, or was before a step
/// at the speed that it has now. In a flight a light foot under a strong motor turns
/// away from a ground on which it stands.
struct TlGroundNearness {
  real margin;  // m
  real dt;  // s
  real twist[6];  // of a group: linear at the origin of TlGroundPose, angular
};
typedef struct TlGroundNearness TlGroundNearness;

/// Whether the ball about a group reaches below a margin. `heights` are those of
/// tl_find_heights: of each group the world's z axis in its own, and its height.
TL_INLINE bool tl_may_touch(const real* heights, int32_t group, real margin) {
  const real* const up = &heights[4 * group];
  const real* const ball = &TL_GROUND_BALLS[4 * group];
  const real lowest =
      up[3] + (up[0] * ball[0]) + (up[1] * ball[1]) + (up[2] * ball[2]);
  return (lowest - ball[3]) < margin;
}

/// Whether anything may be below a margin; false rules it out.
TL_INLINE bool tl_may_any_touch(const real* heights, real margin) {
  bool may = false;
  for (int32_t group = 0; group < TL_GROUND_GROUPS; ++group) {
    may = tl_may_touch(heights, group, margin) || may;
  }
  return may;
}

/// A vector of a group in world axes.
TL_INLINE void tl_turn(const real* R, const real* v, real* x) {
  for (int32_t i = 0; i < 3; ++i) {
    x[i] = (R[3 * i] * v[0]) + (R[(3 * i) + 1] * v[1]) + (R[(3 * i) + 2] * v[2]);
  }
}

/// Where a rim is steepest, and along which line it is level.
TL_INLINE void tl_lay_rim(const real* R, int32_t shape, real* steepest, real* level) {
  real axis[3];
  tl_turn(R, &TL_GROUND_AXES[3 * shape], &axis[0]);
  real length = TL_ZERO;
  for (int32_t i = 0; i < 3; ++i) {
    steepest[i] = (axis[2] * axis[i]) - ((i == 2) ? TL_ONE : TL_ZERO);
    length += steepest[i] * steepest[i];
  }
  length = tl_square_root(length);
  if (length > TL_REAL(1e-9)) {
    for (int32_t i = 0; i < 3; ++i) {
      steepest[i] /= length;
    }
  } else {  // it lies flat
    tl_turn(R, &TL_GROUND_LEVELS[3 * shape], steepest);
  }
  for (int32_t i = 0; i < 3; ++i) {
    const int32_t j = (i + 1) % 3;
    const int32_t k = (i + 2) % 3;
    level[i] = (axis[j] * steepest[k]) - (axis[k] * steepest[j]);
  }
}

/// A speed above that with which any point of a group rises, at least 0.
TL_FUNCTION real tl_largest_rise(
    const TlGroundPose* at, int32_t group, const TlGroundNearness* near) {
  const real* const ball = &TL_GROUND_BALLS[4 * group];
  const real* const w = &near->twist[3];
  real arm[3];
  tl_turn(&at->rotation[9 * group], ball, &arm[0]);
  for (int32_t i = 0; i < 3; ++i) {
    arm[i] += at->position[(3 * group) + i];
  }
  const real rise = near->twist[2] + ((w[0] * arm[1]) - (w[1] * arm[0])) +
      (ball[3] * tl_square_root((w[0] * w[0]) + (w[1] * w[1])));
  return (rise > TL_ZERO) ? rise : TL_ZERO;
}

/// Adds middle + radius * along if that is near.
TL_INLINE void tl_add_point(const TlGroundTouch* middle, const real* along,
    real radius, const TlGroundNearness* near, TlGroundGroup* found) {
  TlGroundTouch* const point = &found->list[found->count];
  *point = *middle;
  for (int32_t i = 0; i < 3; ++i) {
    point->arm[i] += radius * along[i];
  }
  point->depth -= radius * along[2];
  const real gap = -point->depth;
  const real rise = near->twist[2] +
      ((near->twist[3] * point->arm[1]) - (near->twist[4] * point->arm[0]));
  found->count +=
      ((gap < near->margin) || ((gap - (near->dt * rise)) < near->margin)) ? 1 : 0;
}

/// Adds the points of a shape that are near: of a ball the lowest, of a rim the
/// lowest, the highest and the two between.
TL_FUNCTION void tl_add_shape(const TlGroundPose* at, int32_t group, int32_t shape,
    const TlGroundNearness* near, TlGroundGroup* found) {
  const real* const R = &at->rotation[9 * group];
  const real* const axis = &TL_GROUND_AXES[3 * shape];
  const bool is_rim =
      (axis[0] != TL_ZERO) || (axis[1] != TL_ZERO) || (axis[2] != TL_ZERO);
  const real radius = TL_GROUND_RADII[shape];
  real steepest[3] = {TL_ZERO, TL_ZERO, -TL_ONE};
  real level[3] = {TL_ZERO, TL_ZERO, TL_ZERO};
  if (is_rim) {
    tl_lay_rim(R, shape, &steepest[0], &level[0]);
  }
  for (int32_t i = TL_GROUND_POINTS_OF[shape]; i < TL_GROUND_POINTS_OF[shape + 1];
       ++i) {
    TlGroundTouch middle;
    middle.group = group;
    tl_turn(R, &TL_GROUND_POINTS[3 * i], &middle.arm[0]);
    for (int32_t k = 0; k < 3; ++k) {
      middle.arm[k] += at->position[(3 * group) + k];
    }
    middle.depth = -(middle.arm[2] + at->origin[2]);
    for (int32_t side = 0; side < (is_rim ? 4 : 1); ++side) {
      middle.id = (4 * i) + side;
      tl_add_point(&middle, (side < 2) ? &steepest[0] : &level[0],
          ((side % 2) == 0) ? radius : -radius, near, found);
    }
  }
}

TL_INLINE real tl_distance(const real* a, const real* b) {
  const real d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return tl_square_root((d[0] * d[0]) + (d[1] * d[1]) + (d[2] * d[2]));
}

/// The first point to keep: of those as low as the lowest the one farthest from their
/// middle.
TL_FUNCTION int32_t tl_first_extreme(const TlGroundGroup* points) {
  const real same = TL_REAL(1e-7);  // m
  real deepest = points->list[0].depth;
  real middle[3] = {TL_ZERO, TL_ZERO, TL_ZERO};
  const real share = TL_ONE / TL_AS_REAL(points->count);
  for (int32_t i = 0; i < points->count; ++i) {
    deepest = (points->list[i].depth > deepest) ? points->list[i].depth : deepest;
    for (int32_t k = 0; k < 3; ++k) {
      middle[k] += share * points->list[i].arm[k];
    }
  }
  int32_t first = 0;
  real farthest = -TL_ONE;
  for (int32_t i = 0; i < points->count; ++i) {
    const real apart = tl_distance(&points->list[i].arm[0], &middle[0]);
    if (!(points->list[i].depth < (deepest - same)) && (apart > farthest)) {
      first = i;
      farthest = apart;
    }
  }
  return first;
}

/// Keeps at most four points: the lowest, the one farthest from it, and on either
/// side of the line between these the farthest from the line.
TL_FUNCTION void tl_keep_extremes(TlGroundGroup* points) {
  const TlGroundTouch first = points->list[tl_first_extreme(points)];
  real far_off = TL_ZERO;
  int32_t second = 0;
  for (int32_t i = 0; i < points->count; ++i) {
    const real apart = tl_distance(&points->list[i].arm[0], &first.arm[0]);
    second = (apart > far_off) ? i : second;
    far_off = (apart > far_off) ? apart : far_off;
  }
  const real across[2] = {first.arm[1] - points->list[second].arm[1],
      points->list[second].arm[0] - first.arm[0]};
  const real same = TL_REAL(1e-9);  // m
  int32_t sides[2] = {0, 0};
  real most[2] = {TL_ZERO, TL_ZERO};
  for (int32_t i = 0; i < points->count; ++i) {
    const real left = (across[0] * (points->list[i].arm[0] - first.arm[0])) +
        (across[1] * (points->list[i].arm[1] - first.arm[1]));
    for (int32_t side = 0; side < 2; ++side) {
      const real to = (side == 0) ? left : -left;
      sides[side] = (to > most[side]) ? i : sides[side];
      most[side] = (to > most[side]) ? to : most[side];
    }
  }
  const real line =
      same * tl_square_root((across[0] * across[0]) + (across[1] * across[1]));
  const TlGroundTouch kept[3] = {
      points->list[second], points->list[sides[0]], points->list[sides[1]]};
  points->list[0] = first;
  points->count = 1;
  for (int32_t i = 0; i < 3; ++i) {
    const bool apart = (i == 0) ? (far_off > same) : (most[i - 1] > line);
    if (apart) {
      points->list[points->count] = kept[i];
      ++points->count;
    }
  }
}

/// Puts a point behind those that are as deep; the last falls out where all are
/// taken.
TL_INLINE void tl_sort_in(const TlGroundTouch* point, TlGroundTouches* found) {
  int32_t place = found->count;
  while ((place > 0) && (found->list[place - 1].depth < point->depth)) {
    --place;
  }
  const bool is_full = found->count == TL_CONTACTS;
  if (is_full) {
    const real last =
        (place < TL_CONTACTS) ? found->list[TL_CONTACTS - 1].depth : point->depth;
    found->left_out += (last > TL_ZERO) ? 1 : 0;
  }
  for (int32_t i = is_full ? (TL_CONTACTS - 1) : found->count; i > place; --i) {
    found->list[i] = found->list[i - 1];
  }
  if (place < TL_CONTACTS) {
    found->list[place] = *point;
  }
  found->count += is_full ? 0 : 1;
}

/// All points that are lower than a margin, or were before a step of `dt` seconds at
/// the velocities `qd`.
TL_FUNCTION void tl_find_touches(const TlGroundPose* at, const real* heights,
    const real* qd, real margin, real dt, TlGroundTouches* found) {
  TlGroundGroup points;
  TlGroundNearness near;
  near.margin = margin;
  near.dt = dt;
  found->count = 0;
  found->left_out = 0;
  for (int32_t group = 0; group < TL_GROUND_GROUPS; ++group) {
    tl_twist_of(at, qd, group, &near.twist[0]);
    if (tl_may_touch(
            heights, group, margin + (dt * tl_largest_rise(at, group, &near)))) {
      points.count = 0;
      for (int32_t shape = TL_GROUND_SHAPES_OF[group];
           shape < TL_GROUND_SHAPES_OF[group + 1]; ++shape) {
        tl_add_shape(at, group, shape, &near, &points);
      }
      if (points.count > 0) {
        tl_keep_extremes(&points);
      }
      for (int32_t i = 0; i < points.count; ++i) {
        tl_sort_in(&points.list[i], found);
      }
    }
  }
}
