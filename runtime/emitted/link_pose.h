#pragma once
// Poses of the links of a table: what their joints' coordinates make of them.

TL_FOLDED void tl_find_turns(
    const TlLink* link, const TlLinkPose* pose, TlLinkTurns* turns) {
  turns->joint.c = pose->turn.c;
  turns->joint.s = pose->turn.s;
  turns->alpha.c = link->alpha.c;
  turns->alpha.s = link->alpha.s;
  turns->a.c = link->a.c;
  turns->a.s = link->a.s;
}

TL_FOLDED void tl_turn_by_planes(const TlLinkTurns* turns, real* v) {
  tl_turn_plane(&turns->joint, &v[0], &v[1]);
  tl_turn_plane(&turns->alpha, &v[1], &v[2]);
  tl_turn_plane(&turns->a, &v[0], &v[1]);
}

TL_FOLDED void tl_turn_back_by_planes(const TlLinkTurns* turns, real* v) {
  tl_turn_plane_back(&turns->a, &v[0], &v[1]);
  tl_turn_plane_back(&turns->alpha, &v[1], &v[2]);
  tl_turn_plane_back(&turns->joint, &v[0], &v[1]);
}

/// Turns a vector by the rotation of a floating base or of a ball joint.
TL_INLINE void tl_turn_by(const TlLinkRotation* rotation, real* v) {
  const real old[3] = {v[0], v[1], v[2]};
  for (int32_t k = 0; k < 3; ++k) {
    const real* const row = &rotation->Q[3 * k];
    v[k] = (row[0] * old[0]) + (row[1] * old[1]) + (row[2] * old[2]);
  }
}

TL_INLINE void tl_turn_back_by(const TlLinkRotation* rotation, real* v) {
  const real* const Q = &rotation->Q[0];
  const real old[3] = {v[0], v[1], v[2]};
  for (int32_t k = 0; k < 3; ++k) {
    v[k] = (Q[k] * old[0]) + (Q[3 + k] * old[1]) + (Q[6 + k] * old[2]);
  }
}

/// Whether link `i` turns by a rotation of `TlLinkPoses`, not by planes: it has the
/// first axis of a ball joint.
TL_INLINE bool tl_turns_freely(const TlLinkTable* table, int32_t i) {
  return tl_ball_axis(table, i) == 1;
}

TL_INLINE const TlLinkRotation* tl_rotation_of(
    const TlLinkTable* table, int32_t i, const TlLinkPoses* poses) {
  return &poses->rotations[tl_rotation_at(table, i)];
}

/// Three vectors from a link's axes to its parent's. Not for a floating base.
TL_INLINE void tl_turn_axes_to_parent(const TlLinkTable* table, int32_t i,
    const TlLinkPoses* poses, real* x, real* y, real* z) {
  if (tl_turns_freely(table, i)) {
    tl_turn_by(tl_rotation_of(table, i, poses), x);
    tl_turn_by(tl_rotation_of(table, i, poses), y);
    tl_turn_by(tl_rotation_of(table, i, poses), z);
  } else {
    TlLinkTurns turns;
    tl_find_turns(&table->links[i], &poses->joints[i], &turns);
    tl_turn_by_planes(&turns, x);
    tl_turn_by_planes(&turns, y);
    tl_turn_by_planes(&turns, z);
  }
}

/// Three vectors from the axes of a link's parent to its own. Not for a floating
/// base.
TL_INLINE void tl_turn_axes_to_link(const TlLinkTable* table, int32_t i,
    const TlLinkPoses* poses, real* x, real* y, real* z) {
  if (tl_turns_freely(table, i)) {
    tl_turn_back_by(tl_rotation_of(table, i, poses), x);
    tl_turn_back_by(tl_rotation_of(table, i, poses), y);
    tl_turn_back_by(tl_rotation_of(table, i, poses), z);
  } else {
    TlLinkTurns turns;
    tl_find_turns(&table->links[i], &poses->joints[i], &turns);
    tl_turn_back_by_planes(&turns, x);
    tl_turn_back_by_planes(&turns, y);
    tl_turn_back_by_planes(&turns, z);
  }
}

/// Makes of the way along the axis of link `i` that of all three axes, if it is the
/// first of a joint that moves freely, and none, if it is another of these.
TL_INLINE void tl_slide_freely(
    const TlLinkTable* table, int32_t i, const TlLinkPoses* poses, real* along) {
  if (TL_FREED) {
    const int32_t axis = tl_ball_axis(table, i);
    if (axis == 1) {
      along[0] = poses->joints[i + 1].slide;
      along[1] = poses->joints[i + 2].slide;
      tl_turn_plane(&table->links[i].b, &along[0], &along[1]);
    }
    if (axis > 1) {
      along[2] = TL_ZERO;
    }
  } else {
    (void)table;
    (void)i;
    (void)poses;
    (void)along;
  }
}

/// The origin of link `i` in the axes of its parent.
TL_INLINE void tl_find_origin(
    const TlLinkTable* table, int32_t i, const TlLinkPoses* poses, real* p) {
  const TlLink* const link = &table->links[i];
  for (int32_t k = 0; k < 3; ++k) {
    p[k] = link->p[k];
  }
  if (TL_SLIDING) {
    if (link->slides) {
      real along[3];
      tl_clear(&along[0]);
      along[2] = poses->joints[i].slide;
      tl_slide_freely(table, i, poses, &along[0]);
      tl_turn_plane(&link->alpha, &along[1], &along[2]);
      tl_turn_plane(&link->a, &along[0], &along[1]);
      for (int32_t k = 0; k < 3; ++k) {
        p[k] = p[k] + along[k];
      }
    }
  } else {
    (void)poses;
  }
}

/// From a wrench on link `i` to the same on its parent. Not for a floating base.
TL_FOLDED void tl_wrench_to_parent(const TlLinkTable* table, int32_t i,
    const TlLinkPoses* poses, TlSpatial* wrench) {
  real p[3];
  tl_find_origin(table, i, poses, &p[0]);
  if (tl_turns_freely(table, i)) {
    tl_turn_by(tl_rotation_of(table, i, poses), &wrench->linear[0]);
    tl_turn_by(tl_rotation_of(table, i, poses), &wrench->angular[0]);
  } else {
    TlLinkTurns turns;
    tl_find_turns(&table->links[i], &poses->joints[i], &turns);
    tl_turn_by_planes(&turns, &wrench->linear[0]);
    tl_turn_by_planes(&turns, &wrench->angular[0]);
  }
  tl_add_cross(&p[0], &wrench->linear[0], &wrench->angular[0]);
}

/// 2 / |q|^2 of a quaternion of any length, x y z w; of 0 it does not turn.
TL_INLINE real tl_turn_factor(const real* v) {
  const real square = (v[0] * v[0]) + (v[1] * v[1]) + (v[2] * v[2]) + (v[3] * v[3]) +
      TL_REAL(0x1p-100);
  return TL_REAL(2.0) / square;
}

/// Column `j` of the rotation by a quaternion, `twice` its `tl_turn_factor`.
TL_INLINE void tl_turn_axis(const real* v, real twice, int32_t j, real* column) {
  const int32_t k = (j + 1) % 3;
  const int32_t l = (j + 2) % 3;
  const real t = twice * v[j];
  const real tw = twice * v[3];
  column[j] = TL_ONE - (twice * ((v[k] * v[k]) + (v[l] * v[l])));
  column[k] = (t * v[k]) + (tw * v[l]);
  column[l] = (t * v[l]) - (tw * v[k]);
}

/// The rotation by a quaternion behind the placement of a link.
TL_INLINE void tl_place_rotation(
    const TlLink* link, const real* v, TlLinkRotation* rotation) {
  const real twice = tl_turn_factor(v);
  for (int32_t j = 0; j < 3; ++j) {
    real column[3];
    tl_turn_axis(v, twice, j, &column[0]);
    tl_turn_plane(&link->b, &column[0], &column[1]);
    tl_turn_plane(&link->alpha, &column[1], &column[2]);
    tl_turn_plane(&link->a, &column[0], &column[1]);
    for (int32_t m = 0; m < 3; ++m) {
      rotation->Q[(3 * m) + j] = column[m];
    }
  }
}

/// The rotation of a ball joint, whose axes are y z x of its quaternion in those of
/// its first link, and the way that a joint which moves freely takes along the axis
/// of that. The link's own turn is not used.
TL_INLINE void tl_place_ball(
    const TlLinkTable* table, int32_t i, const real* q, TlLinkPoses* poses) {
  int32_t at = 0;
  if (tl_is_freed(table, i)) {
    at = 3;
    poses->joints[i].slide = q[0];
  }
  poses->joints[i].turn.c = TL_ONE;
  poses->joints[i].turn.s = TL_ZERO;
  const real v[4] = {q[at + 1], q[at + 2], q[at], q[at + 3]};
  tl_place_rotation(
      &table->links[i], &v[0], &poses->rotations[tl_rotation_at(table, i)]);
}

/// The rotation that a coordinate makes.
TL_INLINE void tl_turn_joint(
    const TlLinkTable* table, int32_t i, real moved, TlLinkPoses* poses) {
  const TlLink* const link = &table->links[i];
  TlTurn* const turn = &poses->joints[i].turn;
  if (tl_slides(table, i) || tl_spins(table, i) || (tl_ball_axis(table, i) > 1)) {
    turn->c = link->b.c;
    turn->s = link->b.s;
  } else {
    if (TL_GIVEN_SINES) {
      const int32_t at = tl_coordinate_of(table, i);
      turn->c = poses->cos_q[at];
      turn->s = tl_scale(table, i, poses->sin_q[at]);
      if (TL_OWN_SINES) {
        if (table->couplings[i].own_sine) {
          tl_sin_cos_of(moved, &turn->s, &turn->c);
        }
      } else {
        (void)moved;
      }
    } else {
      tl_sin_cos_of(moved, &turn->s, &turn->c);
    }
    tl_turn_plane(&link->b, &turn->c, &turn->s);
  }
}

/// Poses of all links, by the sines and cosines of the joints' angles.
TL_SHARED void tl_place_links(
    const TlLinkTable* table, const real* q, TlLinkPoses* poses) {
  for (int32_t i = 0; i < table->count; ++i) {
    if (tl_is_floating(i)) {
      tl_place_rotation(&table->links[i], &q[3], &poses->rotations[0]);
    } else {
      const int32_t at = tl_coordinate_of(table, i);
      if (tl_turns_freely(table, i)) {
        tl_place_ball(table, i, &q[at], poses);
      } else {
        const real moved = tl_scale(table, i, q[at]);
        poses->joints[i].slide = moved;
        tl_turn_joint(table, i, moved, poses);
      }
    }
  }
}
