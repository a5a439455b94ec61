#pragma once
// Operational points and external forces of a table of links.

TL_INLINE void tl_find_axes(const TlLinkTable* table, const TlLinkPoses* poses,
    int32_t link, TlLinkAxes* axes) {
  real x[3] = {TL_ONE, TL_ZERO, TL_ZERO};
  real y[3] = {TL_ZERO, TL_ONE, TL_ZERO};
  real z[3] = {TL_ZERO, TL_ZERO, TL_ONE};
  for (int32_t i = link; i >= 0; i = table->links[i].parent) {
    if (tl_is_floating(i)) {
      tl_turn_by(&poses->rotations[0], &x[0]);
      tl_turn_by(&poses->rotations[0], &y[0]);
      tl_turn_by(&poses->rotations[0], &z[0]);
    } else {
      tl_turn_axes_to_parent(table, i, poses, &x[0], &y[0], &z[0]);
    }
  }
  for (int32_t m = 0; m < 3; ++m) {
    axes->rows[m] = x[m];
    axes->rows[3 + m] = y[m];
    axes->rows[6 + m] = z[m];
  }
}

/// The direction along an axis of a point, in the axes of its link.
TL_INLINE void tl_find_direction(
    const TlLinkPoint* point, const TlLinkAxes* link_axes, int32_t axis, real* e) {
  for (int32_t j = 0; j < 3; ++j) {
    e[j] =
        point->world ? link_axes->rows[(3 * j) + axis] : point->axes[(3 * axis) + j];
  }
}

/// Takes the external forces at points from the wrenches that move their links.
TL_INLINE void tl_take_external_forces(
    const TlLinkTable* table, TlMotionWork* motions) {
  for (int32_t k = 0; k < table->pushed_count; ++k) {
    const TlLinkPoint* const point = &table->pushed_points[k];
    if (!tl_is_on_world(point->link)) {
      const real* const force = &table->f_ext[6 * k];
      TlLinkAxes axes;
      tl_find_axes(table, &motions->poses, point->link, &axes);
      TlSpatial wrench;
      tl_clear_spatial(&wrench);
      for (int32_t j = 0; j < 3; ++j) {
        real e[3];
        tl_find_direction(point, &axes, j, &e[0]);
        for (int32_t m = 0; m < 3; ++m) {
          wrench.linear[m] = wrench.linear[m] - (e[m] * force[j]);
          wrench.angular[m] = wrench.angular[m] - (e[m] * force[3 + j]);
        }
      }
      tl_add_cross(&point->p[0], &wrench.linear[0], &wrench.angular[0]);
      tl_add(&wrench, &motions->wrenches[point->link]);
    }
  }
}
