#pragma once
// M^-1 by loops over a table of links: articulated bodies.

/// Passes the inertia in the slot of link `i` on to that of its parent. Where both
/// share one, the parent has no other yet.
TL_INLINE void tl_pass_on(const TlLinkTable* table, int32_t i,
    const TlMotionWork* motions, TlLinkInertia* inertia, TlFactorWork* inertias) {
  const TlLink* const link = &table->links[i];
  if (link->parent < 0) {
    tl_clear_inertia(inertia);
  } else {
    tl_inertia_to_parent(table, i, &motions->poses, inertia);
    const int16_t slot = table->links[link->parent].slot;
    if (slot != link->slot) {
      tl_add_inertia(inertia, &inertias->inertias[slot]);
      tl_clear_inertia(inertia);
    }
  }
}

/// U = I S of the joint of link `i`.
TL_FOLDED void tl_find_column(
    const TlLinkTable* table, int32_t i, const TlLinkInertia* inertia, TlSpatial* U) {
  const real* const A = &inertia->A[0];
  const real* const B = &inertia->B[0];
  const real* const C = &inertia->C[0];
  if (tl_slides(table, i)) {
    U->linear[0] = A[2];
    U->linear[1] = A[4];
    U->linear[2] = A[5];
    U->angular[0] = B[6];
    U->angular[1] = B[7];
    U->angular[2] = B[8];
  } else {
    U->linear[0] = B[2];
    U->linear[1] = B[5];
    U->linear[2] = B[8];
    U->angular[0] = C[2];
    U->angular[1] = C[4];
    U->angular[2] = C[5];
  }
}

/// Multiplies the row and column of the joint of link `i` by what its rotor holds.
TL_FOLDED void tl_hold_column(
    const TlLinkTable* table, int32_t i, real held, TlLinkInertia* inertia) {
  real* const A = &inertia->A[0];
  real* const B = &inertia->B[0];
  real* const C = &inertia->C[0];
  if (tl_slides(table, i)) {
    A[2] = A[2] * held;
    A[4] = A[4] * held;
    A[5] = A[5] * held;
    B[6] = B[6] * held;
    B[7] = B[7] * held;
    B[8] = B[8] * held;
  } else {
    B[2] = B[2] * held;
    B[5] = B[5] * held;
    B[8] = B[8] * held;
    C[2] = C[2] * held;
    C[4] = C[4] * held;
    C[5] = C[5] * held;
  }
}

/// M - U u^T of a symmetric M.
TL_FOLDED void tl_take_symmetric(const real* U, const real* u, real* M) {
  M[0] = M[0] - (U[0] * u[0]);
  M[1] = M[1] - (U[0] * u[1]);
  M[2] = M[2] - (U[0] * u[2]);
  M[3] = M[3] - (U[1] * u[1]);
  M[4] = M[4] - (U[1] * u[2]);
  M[5] = M[5] - (U[2] * u[2]);
}

TL_FOLDED void tl_take_square(const real* U, const real* u, real* M) {
  M[0] = M[0] - (U[0] * u[0]);
  M[1] = M[1] - (U[0] * u[1]);
  M[2] = M[2] - (U[0] * u[2]);
  M[3] = M[3] - (U[1] * u[0]);
  M[4] = M[4] - (U[1] * u[1]);
  M[5] = M[5] - (U[1] * u[2]);
  M[6] = M[6] - (U[2] * u[0]);
  M[7] = M[7] - (U[2] * u[1]);
  M[8] = M[8] - (U[2] * u[2]);
}

/// Makes IA what the joint passes on, IA - U D^-1 U^T. Of the joint's own row and
/// column the share rotor / D is left; without a rotor they are exact zeros.
TL_FOLDED void tl_release_joint(
    const TlLinkTable* table, int32_t i, TlLinkInertia* IA, TlLinkProjection* joint) {
  TlSpatial U;
  tl_find_column(table, i, IA, &U);
  real* const own = tl_along_joint(table, i, &U);
  const real rotor = tl_rotor_of(table, i);
  const real inverse_D = TL_ONE / ((*own) + rotor);
  *own = TL_ZERO;
  TlSpatial u;
  tl_scale_spatial(inverse_D, &U, &u);
  tl_take_symmetric(&U.linear[0], &u.linear[0], &IA->A[0]);
  tl_take_square(&U.linear[0], &u.angular[0], &IA->B[0]);
  tl_take_symmetric(&U.angular[0], &u.angular[0], &IA->C[0]);
  tl_hold_column(table, i, rotor * inverse_D, IA);
  joint->inverse_D = inverse_D;
  tl_copy_spatial(&u, &joint->u);
}

/// Inward pass of articulated bodies: u and 1 / D of joints, factors of a floating
/// base. Not where joints share coordinates: see `tl_factor_mass_matrix`.
TL_INLINE void tl_articulate(
    const TlLinkTable* table, const TlMotionWork* motions, TlFactorWork* inertias) {
  for (int32_t k = 0; k < table->slots; ++k) {
    tl_clear_inertia(&inertias->inertias[k]);
  }
  for (int32_t i = table->count - 1; i >= 0; --i) {
    const TlLink* const link = &table->links[i];
    TlLinkInertia* const sum = &inertias->inertias[link->slot];
    TlLinkInertia IA;
    tl_copy_inertia(sum, &IA);
    tl_add_own(tl_body_of(table, i), &IA);
    if (tl_is_floating(i)) {
      tl_copy_to(&IA, &inertias->base[0], 6);
      const real* const none = TL_NONE;
      tl_factor(0, &inertias->base[0], 6, none);
    } else {
      tl_release_joint(table, i, &IA, &inertias->projections[i]);
      tl_copy_inertia(&IA, sum);
      tl_pass_on(table, i, motions, sum, inertias);
    }
  }
}

/// From a twist of the parent of link `i` to the same of the link before its joint.
TL_FOLDED void tl_twist_to_child(
    const TlLinkTable* table, int32_t i, const TlLinkPoses* poses, TlSpatial* twist) {
  real p[3];
  tl_find_origin(table, i, poses, &p[0]);
  tl_add_cross(&twist->angular[0], &p[0], &twist->linear[0]);
  if (tl_turns_freely(table, i)) {
    tl_turn_back_by(tl_rotation_of(table, i, poses), &twist->linear[0]);
    tl_turn_back_by(tl_rotation_of(table, i, poses), &twist->angular[0]);
  } else {
    TlLinkTurns turns;
    tl_find_turns(&table->links[i], &poses->joints[i], &turns);
    tl_turn_back_by_planes(&turns, &twist->linear[0]);
    tl_turn_back_by_planes(&turns, &twist->angular[0]);
  }
}

/// qdd of joint forces `tau` by articulated bodies, once `inertias` is articulated.
/// On entry qdd has the forces at qdd = 0. Uses `wrenches` of `motions`.
TL_INLINE void tl_find_accelerations(const TlLinkTable* table, const real* tau,
    TlMotionWork* motions, const TlFactorWork* inertias, real* qdd) {
  for (int32_t i = 0; i < table->count; ++i) {
    tl_clear_spatial(&motions->wrenches[i]);
  }
  for (int32_t i = table->count - 1; i >= 0; --i) {
    const TlLink* const link = &table->links[i];
    const TlLinkProjection* const joint = &inertias->projections[i];
    TlSpatial wrench;
    tl_copy_spatial(&motions->wrenches[i], &wrench);
    if (tl_is_floating(i)) {
      for (int32_t k = 0; k < 3; ++k) {
        qdd[k] = tau[k] - qdd[k] - wrench.linear[k];
        qdd[k + 3] = tau[k + 3] - qdd[k + 3] - wrench.angular[k];
      }
      tl_solve(&inertias->base[0], 6, qdd);
    } else {
      const int32_t at = tl_velocity_at(i);
      real* const along = tl_along_joint(table, i, &wrench);
      const real missing = tau[at] - qdd[at];
      const real left = missing - (*along);
      qdd[at] = left;
      if (link->parent >= 0) {
        tl_add_scaled(&joint->u, left, &wrench);
        *along = missing - (tl_rotor_of(table, i) * joint->inverse_D * left);
        tl_wrench_to_parent(table, i, &motions->poses, &wrench);
        tl_add(&wrench, &motions->wrenches[link->parent]);
      }
    }
  }
  for (int32_t i = 0; i < table->count; ++i) {
    const TlLink* const link = &table->links[i];
    const TlLinkProjection* const joint = &inertias->projections[i];
    TlSpatial twist;  // acceleration without what velocities add
    if (tl_is_floating(i)) {
      for (int32_t k = 0; k < 3; ++k) {
        twist.linear[k] = qdd[k];
        twist.angular[k] = qdd[k + 3];
      }
    } else {
      const int32_t at = tl_velocity_at(i);
      if (link->parent < 0) {
        tl_clear_spatial(&twist);
      } else {
        tl_copy_spatial(&motions->wrenches[link->parent], &twist);
        tl_twist_to_child(table, i, &motions->poses, &twist);
      }
      real* const along = tl_along_joint(table, i, &twist);
      const real held = tl_rotor_of(table, i) * joint->inverse_D;
      qdd[at] = (joint->inverse_D * qdd[at]) -
          tl_dot(&joint->u.linear[0], &twist.linear[0]) -
          tl_dot(&joint->u.angular[0], &twist.angular[0]) -
          ((*along) - (held * (*along)));
      *along = (*along) + qdd[at];
    }
    tl_copy_spatial(&twist, &motions->wrenches[i]);
  }
}
