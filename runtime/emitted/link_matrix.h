#pragma once
// M by loops over a table of links: composite bodies in common axes, those of the
// root, which is the world or a floating base. There bodies only add up, and an entry
// of M is a product of six numbers by six, where a wrench that is carried from link
// to link takes several times as many operations. Compilers make the rows of M of
// vector instructions. Links are placed from where their limb starts: far from the
// root they would lose digits.

TL_FOLDED void tl_copy_vector(const real* from, real* to) {
  to[0] = from[0];
  to[1] = from[1];
  to[2] = from[2];
}

/// sum += v
TL_FOLDED void tl_add_vector(const real* v, real* sum) {
  sum[0] = sum[0] + v[0];
  sum[1] = sum[1] + v[1];
  sum[2] = sum[2] + v[2];
}

/// The frame of the root itself.
TL_INLINE void tl_set_root(TlLinkFrame* frame) {
  tl_clear(&frame->x[0]);
  tl_clear(&frame->y[0]);
  tl_clear(&frame->z[0]);
  tl_clear(&frame->step[0]);
  tl_clear(&frame->p[0]);
  frame->x[0] = TL_ONE;
  frame->y[1] = TL_ONE;
  frame->z[2] = TL_ONE;
}

/// A link's body in the axes of the root, about the link's origin. The frame is read
/// in a copy, of which a compiler knows that it is no other.
TL_FOLDED void tl_turn_body(
    const TlLinkBody* from, const TlLinkFrame* frame, TlLinkBody* to) {
  real x[3];
  real y[3];
  real z[3];
  tl_copy_vector(&frame->x[0], &x[0]);
  tl_copy_vector(&frame->y[0], &y[0]);
  tl_copy_vector(&frame->z[0], &z[0]);
  to->mass = from->mass;
  to->h[0] = tl_dot(&x[0], &from->h[0]);
  to->h[1] = tl_dot(&y[0], &from->h[0]);
  to->h[2] = tl_dot(&z[0], &from->h[0]);
  real row[3];  // of R J
  tl_multiply_symmetric(&from->J[0], &x[0], &row[0]);
  to->J[0] = tl_dot(&row[0], &x[0]);
  to->J[1] = tl_dot(&row[0], &y[0]);
  to->J[2] = tl_dot(&row[0], &z[0]);
  tl_multiply_symmetric(&from->J[0], &y[0], &row[0]);
  to->J[3] = tl_dot(&row[0], &y[0]);
  to->J[4] = tl_dot(&row[0], &z[0]);
  tl_multiply_symmetric(&from->J[0], &z[0], &row[0]);
  to->J[5] = tl_dot(&row[0], &z[0]);
}

/// Adds a body, whose origin is at p of the sum's, to this. With g = h + m p the
/// moment becomes g, and J grows by (p . (h + g)) 1 - h p^T - p g^T.
TL_FOLDED void tl_add_shifted(
    const TlLinkBody* body, const real* p, TlLinkBody* sum) {
  const real* const h = &body->h[0];
  const real g[3] = {h[0] + (body->mass * p[0]), h[1] + (body->mass * p[1]),
      h[2] + (body->mass * p[2])};
  const real xx = p[0] * (h[0] + g[0]);
  const real yy = p[1] * (h[1] + g[1]);
  const real zz = p[2] * (h[2] + g[2]);
  sum->mass = sum->mass + body->mass;
  sum->h[0] = sum->h[0] + g[0];
  sum->h[1] = sum->h[1] + g[1];
  sum->h[2] = sum->h[2] + g[2];
  sum->J[0] = sum->J[0] + (body->J[0] + (yy + zz));
  sum->J[1] = sum->J[1] + (body->J[1] - ((p[0] * h[1]) + (p[1] * g[0])));
  sum->J[2] = sum->J[2] + (body->J[2] - ((p[0] * h[2]) + (p[2] * g[0])));
  sum->J[3] = sum->J[3] + (body->J[3] + (xx + zz));
  sum->J[4] = sum->J[4] + (body->J[4] - ((p[1] * h[2]) + (p[2] * g[1])));
  sum->J[5] = sum->J[5] + (body->J[5] + (xx + yy));
}

/// The frame of link `i` before it turns.
TL_INLINE void tl_place_frame(const TlLinkTable* table, int32_t i,
    const TlLinkPoses* poses, const TlLinkFrame* parent, TlLinkFrame* frame) {
  real p[3];
  tl_find_origin(table, i, poses, &p[0]);
  frame->step[0] = tl_dot(&parent->x[0], &p[0]);
  frame->step[1] = tl_dot(&parent->y[0], &p[0]);
  frame->step[2] = tl_dot(&parent->z[0], &p[0]);
  if (table->links[i].starts) {
    tl_clear(&frame->p[0]);
  } else {
    tl_copy_vector(&parent->p[0], &frame->p[0]);
    tl_add_vector(&frame->step[0], &frame->p[0]);
  }
  tl_copy_vector(&parent->x[0], &frame->x[0]);
  tl_copy_vector(&parent->y[0], &frame->y[0]);
  tl_copy_vector(&parent->z[0], &frame->z[0]);
}

/// Frames of all links, and their bodies, each alone.
TL_INLINE void tl_place_bodies(
    const TlLinkTable* table, const TlLinkPoses* poses, TlMatrixWork* matrices) {
  for (int32_t i = 0; i < table->count; ++i) {
    const int32_t parent = table->links[i].parent;
    TlLinkFrame* const frame = &matrices->frames[i];
    if (parent < 0) {
      tl_set_root(frame);
    } else {
      tl_place_frame(table, i, poses, &matrices->frames[parent], frame);
    }
    if (!tl_is_floating(i)) {
      tl_turn_axes_to_link(table, i, poses, &frame->x[0], &frame->y[0], &frame->z[0]);
    }
    tl_turn_body(tl_body_of(table, i), frame, &matrices->bodies[i]);
  }
}

/// Adds to the bodies of links those that they carry.
TL_INLINE void tl_compose_bodies(const TlLinkTable* table, TlMatrixWork* matrices) {
  for (int32_t i = table->count - 1; i > 0; --i) {
    const int32_t parent = table->links[i].parent;
    if (parent >= 0) {
      tl_add_shifted(&matrices->bodies[i], &matrices->frames[i].step[0],
          &matrices->bodies[parent]);
    }
  }
}

/// The wrenches that joints need.
TL_INLINE void tl_find_joint_wrenches(
    const TlLinkTable* table, TlMatrixWork* matrices) {
  for (int32_t i = 0; i < table->count; ++i) {
    const TlLinkFrame* const frame = &matrices->frames[i];
    const TlLinkBody* const body = &matrices->bodies[i];
    const real axis[3] = {frame->x[2], frame->y[2], frame->z[2]};
    real f[3];
    real n[3];
    if (tl_slides(table, i)) {
      f[0] = body->mass * axis[0];
      f[1] = body->mass * axis[1];
      f[2] = body->mass * axis[2];
      tl_find_cross(&body->h[0], &axis[0], &n[0]);
    } else {
      tl_find_cross(&axis[0], &body->h[0], &f[0]);
      tl_multiply_symmetric(&body->J[0], &axis[0], &n[0]);
    }
    tl_add_cross(&frame->p[0], &f[0], &n[0]);
    matrices->f_x[i] = f[0];
    matrices->f_y[i] = f[1];
    matrices->f_z[i] = f[2];
    matrices->n_x[i] = n[0];
    matrices->n_y[i] = n[1];
    matrices->n_z[i] = n[2];
  }
}

/// The twist of a joint at unit rate, about where its limb starts.
TL_INLINE void tl_find_joint_twist(
    const TlLinkTable* table, int32_t i, const TlLinkFrame* frame, TlSpatial* twist) {
  const real axis[3] = {frame->x[2], frame->y[2], frame->z[2]};
  if (tl_slides(table, i)) {
    tl_copy_vector(&axis[0], &twist->linear[0]);
    tl_clear(&twist->angular[0]);
  } else {
    tl_find_cross(&frame->p[0], &axis[0], &twist->linear[0]);
    tl_copy_vector(&axis[0], &twist->angular[0]);
  }
}

/// The force along a joint, by its twist, that joint `j` needs.
TL_FOLDED real tl_find_force(
    const TlSpatial* twist, const TlMatrixWork* matrices, int32_t j) {
  return ((twist->angular[0] * matrices->n_x[j]) +
             (twist->angular[1] * matrices->n_y[j]) +
             (twist->angular[2] * matrices->n_z[j])) +
      ((twist->linear[0] * matrices->f_x[j]) + (twist->linear[1] * matrices->f_y[j]) +
          (twist->linear[2] * matrices->f_z[j]));
}

/// The row of the joint of link `i` in M from the diagonal on. Where joints share
/// coordinates it adds to M, and to the column as well.
TL_INLINE void tl_find_joint_row(
    const TlLinkTable* table, int32_t i, const TlMatrixWork* matrices, real* M) {
  const int32_t nv = tl_velocity_at(tl_count_joints(table));
  const int32_t at = tl_velocity_at(tl_joint_of(table, i));
  const int32_t end = table->links[i].end;
  TlSpatial twist;
  tl_find_joint_twist(table, i, &matrices->frames[i], &twist);
  if (TL_COUPLED) {
    for (int32_t j = i; j < end; ++j) {
      const real force =
          tl_scale(table, i, tl_scale(table, j, tl_find_force(&twist, matrices, j)));
      const int32_t other = tl_velocity_at(tl_joint_of(table, j));
      M[(at * nv) + other] = M[(at * nv) + other] + force;
      if (j > i) {
        M[(other * nv) + at] = M[(other * nv) + at] + force;
      }
    }
  } else {
    real* const row = &M[(at * nv) + (at - i)];
    for (int32_t j = i; j < end; ++j) {
      row[j] = tl_find_force(&twist, matrices, j);
    }
  }
  M[(at * nv) + at] = M[(at * nv) + at] + tl_rotor_of(table, i);
}

/// The rows of a floating base in M: its own inertia, and what joints take of it.
TL_INLINE void tl_find_base_rows(
    const TlLinkTable* table, const TlMatrixWork* matrices, real* M) {
  const int32_t nv = tl_velocity_at(tl_count_joints(table));
  TlLinkInertia inertia;
  tl_clear_inertia(&inertia);
  tl_add_own(&matrices->bodies[0], &inertia);
  tl_copy_to(&inertia, M, nv);
  for (int32_t j = 1; j < table->count; ++j) {
    const real wrench[6] = {matrices->f_x[j], matrices->f_y[j], matrices->f_z[j],
        matrices->n_x[j], matrices->n_y[j], matrices->n_z[j]};
    const int32_t at = tl_velocity_at(tl_joint_of(table, j));
    for (int32_t k = 0; k < 6; ++k) {
      const real force = tl_scale(table, j, wrench[k]);
      tl_enter(force, &M[(k * nv) + at]);
      tl_enter(force, &M[(at * nv) + k]);
    }
  }
}

/// Makes moments of what the limb that link `i` starts carries those about where the
/// limb before it starts.
TL_INLINE void tl_move_moments(
    const TlLinkTable* table, int32_t i, TlMatrixWork* matrices) {
  real p[3];
  tl_copy_vector(&matrices->frames[table->links[i].parent].p[0], &p[0]);
  tl_add_vector(&matrices->frames[i].step[0], &p[0]);
  const int32_t end = table->links[i].end;
  for (int32_t j = i; j < end; ++j) {
    const real f[3] = {matrices->f_x[j], matrices->f_y[j], matrices->f_z[j]};
    matrices->n_x[j] = matrices->n_x[j] + ((p[1] * f[2]) - (p[2] * f[1]));
    matrices->n_y[j] = matrices->n_y[j] + ((p[2] * f[0]) - (p[0] * f[2]));
    matrices->n_z[j] = matrices->n_z[j] + ((p[0] * f[1]) - (p[1] * f[0]));
  }
}

/// Copies the upper triangle of M to the lower, unless that is done.
TL_INLINE void tl_mirror(const TlLinkTable* table, real* M) {
  if (TL_COUPLED) {
    (void)table;
    (void)M;
  } else {
    const int32_t nv = tl_velocity_at(tl_count_joints(table));
    for (int32_t k = 1; k < nv; ++k) {
      for (int32_t l = 0; l < k; ++l) {
        M[(k * nv) + l] = M[(l * nv) + k];
      }
    }
  }
}

/// M by composite bodies. Uses `matrices` alone.
TL_INLINE void tl_find_mass_matrix(const TlLinkTable* table,
    const TlMotionWork* motions, TlMatrixWork* matrices, real* M) {
  const int32_t nv = tl_velocity_at(tl_count_joints(table));
  for (int32_t k = 0; k < (nv * nv); ++k) {
    M[k] = TL_ZERO;
  }
  tl_place_bodies(table, &motions->poses, matrices);
  tl_compose_bodies(table, matrices);
  tl_find_joint_wrenches(table, matrices);
  for (int32_t i = table->count - 1; i >= 0; --i) {
    if (tl_is_floating(i)) {
      tl_find_base_rows(table, matrices, M);
    } else {
      tl_find_joint_row(table, i, matrices, M);
      if (table->links[i].starts && (table->links[i].parent >= 0)) {
        tl_move_moments(table, i, matrices);
      }
    }
  }
  tl_mirror(table, M);
}
