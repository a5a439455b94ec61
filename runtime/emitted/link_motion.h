#pragma once
// Inverse dynamics by loops over a table of links: recursive Newton-Euler.

/// sum += wd x r + w x (w x r)
TL_FOLDED void tl_add_rotation(const TlLinkMotion* motion, const real* r, real* sum) {
  real speed[3];
  tl_find_cross(&motion->w[0], r, &speed[0]);
  tl_add_cross(&motion->wd[0], r, sum);
  tl_add_cross(&motion->w[0], &speed[0], sum);
}

/// product = M v of a symmetric M: xx xy xz yy yz zz
TL_FOLDED void tl_multiply_symmetric(const real* M, const real* v, real* product) {
  product[0] = (M[0] * v[0]) + (M[1] * v[1]) + (M[2] * v[2]);
  product[1] = (M[1] * v[0]) + (M[3] * v[1]) + (M[4] * v[2]);
  product[2] = (M[2] * v[0]) + (M[4] * v[1]) + (M[5] * v[2]);
}

TL_FOLDED void tl_copy(const TlLinkMotion* from, TlLinkMotion* to) {
  to->w[0] = from->w[0];
  to->w[1] = from->w[1];
  to->w[2] = from->w[2];
  to->wd[0] = from->wd[0];
  to->wd[1] = from->wd[1];
  to->wd[2] = from->wd[2];
  to->a[0] = from->a[0];
  to->a[1] = from->a[1];
  to->a[2] = from->a[2];
}

/// The motion of a fixed base.
TL_INLINE void tl_rest(const TlLinkTable* table, TlLinkMotion* motion) {
  for (int32_t k = 0; k < 3; ++k) {
    motion->w[k] = TL_ZERO;
    motion->wd[k] = TL_ZERO;
    motion->a[k] = -table->gravity[k];
  }
}

/// An entry of an argument that may be missing: then it is 0.
TL_INLINE real tl_entry(const real* argument, int32_t i) {
  return (argument == TL_NONE) ? TL_ZERO : argument[i];
}

/// Adds the rate at which a link turns the axes of the ball joint that it carries,
/// where the first of these is the joint's: w x (qd about its three axes).
TL_INLINE void tl_turn_ball_axes(const real* qd, int32_t at, TlLinkMotion* motion) {
  const real rate[3] = {tl_entry(qd, at + 1), tl_entry(qd, at + 2), tl_entry(qd, at)};
  tl_add_cross(&motion->w[0], &rate[0], &motion->wd[0]);
}

/// Adds the rate at which a link turns the velocity of a joint that moves freely: (2
/// w + the joint's angular velocity) x v.
TL_INLINE void tl_turn_free_axes(const real* qd, int32_t at, TlLinkMotion* motion) {
  const real v[3] = {tl_entry(qd, at + 1), tl_entry(qd, at + 2), tl_entry(qd, at)};
  real w[3] = {tl_entry(qd, at + 4), tl_entry(qd, at + 5), tl_entry(qd, at + 3)};
  for (int32_t k = 0; k < 3; ++k) {
    w[k] = w[k] + (TL_REAL(2.0) * motion->w[k]);
  }
  tl_add_cross(&w[0], &v[0], &motion->a[0]);
}

/// Adds what the velocity of joint `i`, whose axis its parent turns, adds: w x S qd,
/// or twice that where it slides.
TL_INLINE void tl_turn_joint_axis(
    const TlLinkTable* table, int32_t i, real qd, TlLinkMotion* motion) {
  const bool along = tl_slides(table, i);
  real* const moved = along ? &motion->a[0] : &motion->wd[0];
  real rate = qd;
  if (along) {
    rate = TL_REAL(2.0) * qd;
  }
  moved[0] = moved[0] + (motion->w[1] * rate);
  moved[1] = moved[1] - (motion->w[0] * rate);
}

/// Makes the motion of its parent that of link `i` behind its joint.
TL_FOLDED void tl_move_link(const TlLinkTable* table, int32_t i,
    const TlLinkPoses* poses, const real* qd, const real* qdd, TlLinkMotion* motion) {
  real p[3];
  tl_find_origin(table, i, poses, &p[0]);
  tl_add_rotation(motion, &p[0], &motion->a[0]);
  tl_turn_axes_to_link(table, i, poses, &motion->w[0], &motion->wd[0], &motion->a[0]);
  const int32_t at = tl_velocity_at(tl_joint_of(table, i));
  const real rate = tl_scale(table, i, tl_entry(qd, at));
  if (tl_turns_freely(table, i)) {
    int32_t angular = at;
    if (tl_is_freed(table, i)) {
      tl_turn_free_axes(qd, at, motion);
      angular = at + 3;
    }
    tl_turn_ball_axes(qd, angular, motion);
  }
  if (tl_ball_axis(table, i) == 0) {
    tl_turn_joint_axis(table, i, rate, motion);
  }
  const bool along = tl_slides(table, i);
  real* const moved = along ? &motion->a[0] : &motion->wd[0];
  moved[2] = moved[2] + tl_scale(table, i, tl_entry(qdd, at));
  if (!along) {
    motion->w[2] = motion->w[2] + rate;
  }
}

TL_INLINE void tl_move_base(const TlLinkTable* table, const TlLinkRotation* base,
    const real* qd, const real* qdd, TlLinkMotion* motion) {
  const real* const Q = &base->Q[0];
  real v[3];
  for (int32_t k = 0; k < 3; ++k) {
    v[k] = tl_entry(qd, k);
    motion->w[k] = tl_entry(qd, k + 3);
    motion->wd[k] = tl_entry(qdd, k + 3);
    motion->a[k] = tl_entry(qdd, k) -
        ((Q[k] * table->gravity[0]) + (Q[3 + k] * table->gravity[1]) +
            (Q[6 + k] * table->gravity[2]));
  }
  tl_add_cross(&motion->w[0], &v[0], &motion->a[0]);
}

/// Rate of change of a link's momentum: f = m a + wd x h + w x (w x h), n = J wd + w
/// x J w + h x a. It is found in a copy, of which a compiler knows that it is none of
/// the others.
TL_FOLDED void tl_find_wrench(
    const TlLinkBody* body, const TlLinkMotion* motion, TlSpatial* wrench) {
  TlSpatial rate;
  real momentum[3];
  tl_multiply_symmetric(&body->J[0], &motion->w[0], &momentum[0]);
  tl_multiply_symmetric(&body->J[0], &motion->wd[0], &rate.angular[0]);
  rate.linear[0] = body->mass * motion->a[0];
  rate.linear[1] = body->mass * motion->a[1];
  rate.linear[2] = body->mass * motion->a[2];
  tl_add_rotation(motion, &body->h[0], &rate.linear[0]);
  tl_add_cross(&motion->w[0], &momentum[0], &rate.angular[0]);
  tl_add_cross(&body->h[0], &motion->a[0], &rate.angular[0]);
  tl_copy_spatial(&rate, wrench);
}

/// Motions of the table's points on the world.
TL_INLINE void tl_rest_points(const TlLinkTable* table, TlLinkMotion* point_motions) {
  if (TL_GROUNDED) {
    for (int32_t k = 0; k < table->point_count; ++k) {
      if (tl_is_on_world(table->points[k].link)) {
        tl_rest(table, &point_motions[k]);
      }
    }
  } else {
    (void)table;
    (void)point_motions;
  }
}

/// Outward pass: wrenches that move the links, and motions of the table's points.
/// Without qd or qdd these are 0.
TL_INLINE void tl_move_links(const TlLinkTable* table, const real* qd,
    const real* qdd, TlMotionWork* motions, TlLinkMotion* point_motions) {
  tl_rest_points(table, point_motions);
  for (int32_t i = 0; i < table->count; ++i) {
    const TlLink* const link = &table->links[i];
    TlLinkMotion motion;
    if (tl_is_floating(i)) {
      tl_move_base(table, &motions->poses.rotations[0], qd, qdd, &motion);
    } else {
      if (link->parent < 0) {
        tl_rest(table, &motion);
      } else {
        tl_copy(&motions->motions[table->links[link->parent].slot], &motion);
      }
      tl_move_link(table, i, &motions->poses, qd, qdd, &motion);
    }
    tl_find_wrench(tl_body_of(table, i), &motion, &motions->wrenches[i]);
    tl_copy(&motion, &motions->motions[link->slot]);
    for (int32_t k = 0; k < table->point_count; ++k) {
      if (table->points[k].link == i) {
        tl_copy(&motion, &point_motions[k]);
      }
    }
  }
}

/// Adds what viscous friction and the spring of a joint take.
TL_INLINE void tl_add_drive(
    const TlLinkTable* table, int32_t i, real q, real qd, real* tau) {
  if (table->drives != TL_NONE) {
    const TlLinkDrive* const drive = &table->drives[i];
    real away = q - drive->rest;
    if (TL_STEPPED) {
      if (table->step != TL_NONE) {
        away = away + (table->step[0] * qd);
      }
    }
    *tau = (*tau) + (drive->damping * qd) + (drive->stiffness * away);
  }
}

/// Adds what the Coulomb friction of a joint takes.
TL_INLINE void tl_add_friction(
    const TlLinkTable* table, int32_t i, real qd, real* tau) {
  if (table->frictions != TL_NONE) {
    const TlLinkFriction* const friction = &table->frictions[i];
    *tau = (*tau) + (friction->force * tl_friction_sign(friction->sharpness * qd));
  }
}

/// D + step K of joint `i`, whose velocity is `qd`: D is the derivative of its
/// friction, K its stiffness.
TL_INLINE real tl_drive_slope(
    const TlLinkTable* table, int32_t i, real step, real qd) {
  real slope = TL_ZERO;
  if (TL_DRIVEN) {
    if (table->drives != TL_NONE) {
      const TlLinkDrive* const drive = &table->drives[i];
      slope = drive->damping + (step * drive->stiffness);
    }
  } else {
    (void)step;
  }
  if (TL_RUBBING) {
    if (table->frictions != TL_NONE) {
      const TlLinkFriction* const friction = &table->frictions[i];
      slope = slope +
          ((friction->force * friction->sharpness) *
              tl_friction_slope(friction->sharpness * qd));
    }
  } else {
    (void)table;
    (void)i;
    (void)qd;
  }
  return slope;
}

/// The inertias of joints that make friction and springs those at the end of the
/// table's step: rotor + step D + step^2 K. They may take the place of those that an
/// argument gives.
TL_INLINE void tl_find_rotors(
    const TlLinkTable* table, const real* qd, real* rotors) {
  const real step = table->step[0];
  for (int32_t i = 0; i < table->count; ++i) {
    const real speed = tl_entry(qd, tl_velocity_at(tl_joint_of(table, i)));
    rotors[i] =
        tl_rotor_of(table, i) + (step * tl_drive_slope(table, i, step, speed));
  }
}

/// Clears what joints add to.
TL_INLINE void tl_clear_shared(const TlLinkTable* table, real* tau) {
  if (TL_COUPLED) {
    for (int32_t k = 0; k < tl_velocity_at(table->joints); ++k) {
      tau[k] = TL_ZERO;
    }
  } else {
    (void)table;
    (void)tau;
  }
}

/// Inward pass: joint forces of the wrenches on links, which become those on what
/// links carry.
TL_SHARED void tl_gather_forces(const TlLinkTable* table, const real* q,
    const real* qd, const real* qdd, TlMotionWork* motions, real* tau) {
  tl_clear_shared(table, tau);
  for (int32_t i = table->count - 1; i >= 0; --i) {
    const TlLink* const link = &table->links[i];
    TlSpatial wrench;
    tl_copy_spatial(&motions->wrenches[i], &wrench);
    if (tl_is_floating(i)) {
      for (int32_t k = 0; k < 3; ++k) {
        tau[k] = wrench.linear[k];
        tau[k + 3] = wrench.angular[k];
      }
    } else {
      const int32_t at = tl_velocity_at(tl_joint_of(table, i));
      const real force = tl_scale(table, i, (*tl_along_joint(table, i, &wrench)));
      tl_enter(force + (tl_rotor_of(table, i) * tl_entry(qdd, at)), &tau[at]);
      if (TL_DRIVEN) {
        tl_add_drive(
            table, i, q[tl_coordinate_of(table, i)], tl_entry(qd, at), &tau[at]);
      } else {
        (void)q;
        (void)qd;
      }
      if (TL_RUBBING) {
        tl_add_friction(table, i, tl_entry(qd, at), &tau[at]);
      }
      if (link->parent >= 0) {
        tl_wrench_to_parent(table, i, &motions->poses, &wrench);
        tl_add(&wrench, &motions->wrenches[link->parent]);
      }
    }
  }
}
