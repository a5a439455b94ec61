#pragma once
// M^-1 and Lambda^-1 by factors of M, where joints share coordinates.

/// Factors of M to `base` of `factors`, where joints share coordinates.
TL_INLINE void tl_factor_mass_matrix(
    const TlLinkTable* table, const TlMotionWork* motions, TlFactorWork* factors) {
  const real* const none = TL_NONE;
  tl_find_mass_matrix(table, motions, &factors->matrix, &factors->base[0]);
  tl_factor(0, &factors->base[0], tl_velocity_at(tl_count_joints(table)), none);
}

/// qdd of joint forces `tau` by factors of M. On entry qdd has the forces at qdd = 0.
TL_INLINE void tl_solve_accelerations(const TlLinkTable* table, const real* tau,
    const TlFactorWork* factors, real* qdd) {
  const int32_t nv = tl_velocity_at(tl_count_joints(table));
  for (int32_t k = 0; k < nv; ++k) {
    qdd[k] = tau[k] - qdd[k];
  }
  tl_solve(&factors->base[0], nv, qdd);
}

/// The joint forces of the unit force of row `r`: a row of the Jacobian.
TL_INLINE void tl_find_joint_forces(const TlLinkTable* table,
    const TlMotionWork* motions, const TlRowWork* rows, int32_t r, real* forces) {
  for (int32_t k = 0; k < tl_velocity_at(tl_count_joints(table)); ++k) {
    forces[k] = TL_ZERO;
  }
  TlSpatial wrench;
  tl_find_unit_force(table, rows, r, &wrench);
  for (int32_t i = table->points[table->point_rows[r].point].link; i >= 0;
       i = table->links[i].parent) {
    if (tl_is_floating(i)) {
      for (int32_t k = 0; k < 3; ++k) {
        forces[k] = wrench.linear[k];
        forces[k + 3] = wrench.angular[k];
      }
    } else {
      const int32_t at = tl_velocity_at(tl_joint_of(table, i));
      forces[at] =
          forces[at] + tl_scale(table, i, (*tl_along_joint(table, i, &wrench)));
      tl_wrench_to_parent(table, i, &motions->poses, &wrench);
    }
  }
}

/// The lower triangle of Lambda^-1 = Y D^-1 Y^T, Y^T = L^-1 J^T, once M is factored
/// to L D L^T.
TL_INLINE void tl_project_rows(const TlLinkTable* table, const TlMotionWork* motions,
    TlFactorWork* factors, TlRowWork* rows) {
  const int32_t nv = tl_velocity_at(tl_count_joints(table));
  for (int32_t r = 0; r < table->rows; ++r) {
    real* const own = &factors->base[nv * (nv + r)];
    tl_find_joint_forces(table, motions, rows, r, own);
    tl_solve_lower(&factors->base[0], nv, own);
    for (int32_t s = 0; s <= r; ++s) {
      const real* const other = &factors->base[nv * (nv + s)];
      real sum = TL_ZERO;
      for (int32_t k = 0; k < nv; ++k) {
        sum = sum + ((own[k] * factors->base[(nv + 1) * k]) * other[k]);
      }
      rows->Lambda_inv[(r * table->rows) + s] = sum;
    }
  }
}
