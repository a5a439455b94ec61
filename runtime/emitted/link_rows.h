#pragma once
// Functions of operational points by loops over a table of links: Lambda^-1, Lambda,
// control torque.

TL_INLINE void tl_find_point_axes(
    const TlLinkTable* table, const TlMotionWork* motions, TlRowWork* rows) {
  for (int32_t p = 0; p < table->point_count; ++p) {
    tl_find_axes(table, &motions->poses, table->points[p].link, &rows->link_axes[p]);
  }
}

/// The wrench on the point's link of a force, or moment, along row `r`.
TL_INLINE void tl_find_unit_force(
    const TlLinkTable* table, const TlRowWork* rows, int32_t r, TlSpatial* wrench) {
  const TlPointRow* const row = &table->point_rows[r];
  const TlLinkPoint* const point = &table->points[row->point];
  tl_clear_spatial(wrench);
  if (row->angular) {
    tl_find_direction(
        point, &rows->link_axes[row->point], row->axis, &wrench->angular[0]);
  } else {
    tl_find_direction(
        point, &rows->link_axes[row->point], row->axis, &wrench->linear[0]);
    tl_add_cross(&point->p[0], &wrench->linear[0], &wrench->angular[0]);
  }
}

/// Adds to row `r` of Lambda^-1, from column `first` on, `scaled` times the work of
/// the other rows, which `errors` has.
TL_FOLDED void tl_add_work(const TlLinkTable* table, real scaled, int32_t first,
    int32_t r, TlRowWork* rows) {
  real* const sums = &rows->Lambda_inv[r * table->rows];
  int32_t s = first;
  do {
    sums[s] = sums[s] + (scaled * rows->errors[s]);
    ++s;
  } while (s <= r);
}

/// Lambda^-1 += K^T IA^-1 K for the unit forces that have got to a floating base,
/// link `i`.
TL_INLINE void tl_absorb_in_base(const TlLinkTable* table, int32_t i,
    const TlFactorWork* inertias, TlRowWork* rows) {
  for (int32_t r = 0; r < table->rows; ++r) {
    TlSpatial* const K = &rows->forces[r];
    if (rows->links[r] == i) {
      real x[6];
      for (int32_t m = 0; m < 3; ++m) {
        x[m] = K->linear[m];
        x[m + 3] = K->angular[m];
      }
      tl_solve_lower(&inertias->base[0], 6, x);
      for (int32_t m = 0; m < 3; ++m) {
        K->linear[m] = x[m];
        K->angular[m] = x[m + 3];
      }
    } else {
      tl_clear_spatial(K);
    }
  }
  for (int32_t m = 0; m < 6; ++m) {
    for (int32_t r = 0; r < table->rows; ++r) {
      const TlSpatial* const K = &rows->forces[r];
      rows->errors[r] = (m < 3) ? K->linear[m] : K->angular[m - 3];
      tl_add_work(table, rows->errors[r] * inertias->base[7 * m], 0, r, rows);
    }
  }
}

/// Lambda^-1 gains what the forces that have got to link `i` do on its joint, which
/// passes the rest of them on. `errors` has the work of each row, 0 of one that has
/// not got there.
TL_INLINE void tl_absorb_in_joint(const TlLinkTable* table, int32_t i,
    const TlMotionWork* motions, const TlLinkProjection* joint, TlRowWork* rows) {
  real p[3];
  tl_find_origin(table, i, &motions->poses, &p[0]);
  TlLinkTurns turns;
  tl_find_turns(&table->links[i], &motions->poses.joints[i], &turns);
  TlSpatial u;
  tl_copy_spatial(&joint->u, &u);
  const real inverse_D = joint->inverse_D;
  const real held = tl_rotor_of(table, i) * inverse_D;
  int32_t first = table->rows;
  for (int32_t r = 0; r < table->rows; ++r) {
    rows->errors[r] = TL_ZERO;
    if (rows->links[r] == i) {
      if (r < first) {
        first = r;
      }
      TlSpatial K;
      tl_copy_spatial(&rows->forces[r], &K);
      const real along = (*tl_along_joint(table, i, &K));
      rows->errors[r] = along;
      tl_add_work(table, along * inverse_D, first, r, rows);
      tl_add_scaled(&u, -along, &K);
      (*tl_along_joint(table, i, &K)) = held * along;
      if (tl_turns_freely(table, i)) {
        tl_turn_by(tl_rotation_of(table, i, &motions->poses), &K.linear[0]);
        tl_turn_by(tl_rotation_of(table, i, &motions->poses), &K.angular[0]);
      } else {
        tl_turn_by_planes(&turns, &K.linear[0]);
        tl_turn_by_planes(&turns, &K.angular[0]);
      }
      tl_add_cross(&p[0], &K.linear[0], &K.angular[0]);
      tl_copy_spatial(&K, &rows->forces[r]);
      rows->links[r] = table->links[i].parent;
    }
  }
}

/// The lower triangle of Lambda^-1, the sum over joints of (S^T K)^T D^-1 (S^T K)
/// with the unit forces K of the rows propagated inward (PV-OSIM), once `inertias` is
/// articulated. Uses `errors`.
TL_INLINE void tl_propagate_forces(const TlLinkTable* table,
    const TlMotionWork* motions, const TlFactorWork* inertias, TlRowWork* rows) {
  for (int32_t k = 0; k < (table->rows * table->rows); ++k) {
    rows->Lambda_inv[k] = TL_ZERO;
  }
  for (int32_t r = 0; r < table->rows; ++r) {
    tl_find_unit_force(table, rows, r, &rows->forces[r]);
    rows->links[r] = table->points[table->point_rows[r].point].link;
  }
  for (int32_t i = table->count - 1; i >= 0; --i) {
    if (tl_is_floating(i)) {
      tl_absorb_in_base(table, i, inertias, rows);
    } else {
      tl_absorb_in_joint(table, i, motions, &inertias->projections[i], rows);
    }
  }
}

/// Lambda^-1 from its lower triangle.
TL_INLINE void tl_copy_lambda_inverse(
    const TlLinkTable* table, const TlRowWork* rows, real* Lambda_inv) {
  const int32_t n = table->rows;
  for (int32_t r = 0; r < n; ++r) {
    const int32_t row = tl_entry_of(table, r);
    for (int32_t s = 0; s <= r; ++s) {
      const int32_t column = tl_entry_of(table, s);
      Lambda_inv[(column * n) + row] = rows->Lambda_inv[(r * n) + s];
      Lambda_inv[(row * n) + column] = rows->Lambda_inv[(r * n) + s];
    }
  }
}

/// Lambda from the lower triangle of Lambda^-1, which is lost. Rows are eliminated in
/// the order of results: the last of those that depend on each other yield. For
/// `power` and `yields` see `tl_factor`.
TL_INLINE void tl_invert_rows(int32_t power, const TlLinkTable* table,
    const real* yields, TlRowWork* rows, real* Lambda) {
  const int32_t n = table->rows;
  if (TL_SORTED) {
    tl_copy_lambda_inverse(table, rows, Lambda);
    for (int32_t k = 0; k < (n * n); ++k) {
      rows->Lambda_inv[k] = Lambda[k];
    }
  }
  tl_factor(power, &rows->Lambda_inv[0], n, yields);
  tl_invert_lower(&rows->Lambda_inv[0], n);
  tl_multiply_inverses(&rows->Lambda_inv[0], n, Lambda);
}

/// 1 over the border of each row in the order of priority: 2^-13 of the inverse
/// inertia, of which the lower triangle is read, that its point has to translation,
/// or to rotation, and of `floors` more. That is a sum over the point's rows.
TL_INLINE void tl_find_inverse_borders(
    const TlLinkTable* table, const real* floors, TlRowWork* rows) {
  for (int32_t r = 0; r < table->rows; ++r) {
    const TlPointRow* const row = &table->point_rows[r];
    real mobility = floors[r];
    for (int32_t s = 0; s < table->rows; ++s) {
      const TlPointRow* const other = &table->point_rows[s];
      if ((other->point == row->point) && (other->angular == row->angular)) {
        mobility = mobility + rows->Lambda_inv[(table->rows + 1) * s];
      }
    }
    rows->inverse_borders[r] = TL_REAL(8192.0) / mobility;
  }
}

/// xdd_cmd - (Jd qd + J qdd_0), from the motions of the points.
TL_INLINE void tl_find_errors(
    const TlLinkTable* table, const real* xdd_cmd, TlRowWork* rows) {
  for (int32_t r = 0; r < table->rows; ++r) {
    const TlPointRow* const row = &table->point_rows[r];
    const TlLinkPoint* const point = &table->points[row->point];
    const TlLinkMotion* const motion = &rows->point_motions[row->point];
    real e[3];
    tl_find_direction(point, &rows->link_axes[row->point], row->axis, &e[0]);
    real moved[3];
    for (int32_t j = 0; j < 3; ++j) {
      const real* const own = &rows->link_axes[row->point].rows[3 * j];
      const real weight = (own[0] * table->gravity[0]) +
          (own[1] * table->gravity[1]) + (own[2] * table->gravity[2]);
      moved[j] = row->angular ? motion->wd[j] : (motion->a[j] + weight);
    }
    if (!row->angular) {
      tl_add_rotation(motion, &point->p[0], &moved[0]);
    }
    rows->errors[r] = xdd_cmd[tl_entry_of(table, r)] - tl_dot(&e[0], &moved[0]);
  }
}

/// The power of a wrench on a link, in its axes, as the robot moves at qd. Loses the
/// wrench.
TL_INLINE real tl_find_power(const TlLinkTable* table, const TlMotionWork* motions,
    int32_t link, const real* qd, TlSpatial* wrench) {
  real power = TL_ZERO;
  for (int32_t i = link; i >= 0; i = table->links[i].parent) {
    if (tl_is_floating(i)) {
      for (int32_t k = 0; k < 3; ++k) {
        power =
            power + (wrench->linear[k] * qd[k]) + (wrench->angular[k] * qd[k + 3]);
      }
    } else {
      const int32_t at = tl_velocity_at(tl_joint_of(table, i));
      power =
          power + (tl_scale(table, i, (*tl_along_joint(table, i, wrench))) * qd[at]);
      tl_wrench_to_parent(table, i, &motions->poses, wrench);
    }
  }
  return power;
}

/// Makes of the errors of linear rows e in axes that turn with their link those of
/// the rates of their velocities, which are less than accelerations by e . (w x v):
/// the power of a force e x w at the point.
TL_INLINE void tl_count_in_turning_axes(const TlLinkTable* table,
    const TlMotionWork* motions, const real* qd, TlRowWork* rows) {
  for (int32_t r = 0; r < table->rows; ++r) {
    const TlPointRow* const row = &table->point_rows[r];
    const TlLinkPoint* const point = &table->points[row->point];
    if (!point->world && !row->angular && !tl_is_on_world(point->link)) {
      const TlLinkMotion* const motion = &rows->point_motions[row->point];
      real e[3];
      tl_find_direction(point, &rows->link_axes[row->point], row->axis, &e[0]);
      TlSpatial wrench;
      tl_clear_spatial(&wrench);
      tl_add_cross(&e[0], &motion->w[0], &wrench.linear[0]);
      tl_add_cross(&point->p[0], &wrench.linear[0], &wrench.angular[0]);
      rows->errors[r] =
          rows->errors[r] + tl_find_power(table, motions, point->link, qd, &wrench);
    }
  }
}

/// Adds the wrenches of forces along the rows to those of links: J^T F.
TL_INLINE void tl_add_row_forces(
    const TlLinkTable* table, const TlRowWork* rows, TlMotionWork* motions) {
  for (int32_t r = 0; r < table->rows; ++r) {
    const int32_t link = table->points[table->point_rows[r].point].link;
    if (!tl_is_on_world(link)) {
      TlSpatial wrench;
      tl_find_unit_force(table, rows, r, &wrench);
      for (int32_t k = 0; k < 3; ++k) {
        wrench.linear[k] = wrench.linear[k] * rows->errors[r];
        wrench.angular[k] = wrench.angular[k] * rows->errors[r];
      }
      tl_add(&wrench, &motions->wrenches[link]);
    }
  }
}
