#pragma once
// Functions of operational points by loops over a table of links: Lambda^-1, Lambda, control
// torque. C++17, freestanding.

#include "core/link_articulation.hpp"

namespace treeline::core::loops {

/// The rotation of a link: row j is its axis j, in the axes of the world.
template <class Real>
struct LinkAxes {
  Real rows[9];
};

template <class Table, class Poses, class Real>
void find_axes(const Table& table, const Poses& poses, int link, LinkAxes<Real>& axes) noexcept {
  Real x[3] = {Real(1.0), Real(0.0), Real(0.0)};
  Real y[3] = {Real(0.0), Real(1.0), Real(0.0)};
  Real z[3] = {Real(0.0), Real(0.0), Real(1.0)};
  for (int i = link; i >= 0; i = table.links[i].parent) {
    if (is_floating<Table>(i)) {
      turn_by(poses.rotations[0], x);
      turn_by(poses.rotations[0], y);
      turn_by(poses.rotations[0], z);
    } else {
      turn_axes_to_parent(table, i, poses, x, y, z);
    }
  }
  for (int m = 0; m < 3; ++m) {
    axes.rows[m] = x[m];
    axes.rows[3 + m] = y[m];
    axes.rows[6 + m] = z[m];
  }
}

/// `ranked`: the rows, where they are in the order of priority; else 1.
template <class Real, size_t points, size_t rows, size_t ranked = 1>
struct RowWork {
  LinkAxes<Real> link_axes[points];  ///< of the points' links
  LinkMotion<Real> point_motions[points];
  Spatial<Real> forces[rows];  ///< unit forces on their way to the base
  int16_t links[rows];         ///< where they have got to
  Real errors[rows];
  Real Lambda_inv[rows * rows];
  Real inverse_borders[ranked];  ///< by which rows in the order of priority yield
};

template <class Table, class Motions, class Rows>
void find_point_axes(const Table& table, const Motions& motions, Rows& rows) noexcept {
  for (int p = 0; p < table.point_count; ++p) {
    find_axes(table, motions.poses, table.points[p].link, rows.link_axes[p]);
  }
}

/// The direction along an axis of a point, in the axes of its link.
template <class Real>
void find_direction(const LinkPoint<Real>& point, const LinkAxes<Real>& link_axes, int axis,
                    Real (&e)[3]) noexcept {
  for (int j = 0; j < 3; ++j) {
    e[j] = point.world ? link_axes.rows[(3 * j) + axis] : point.axes[(3 * axis) + j];
  }
}

/// Takes the external forces at points from the wrenches that move their links.
template <class Table, class Motions, class Real = typename Table::Real>
void take_external_forces(const Table& table, Motions& motions) noexcept {
  for (int k = 0; k < table.pushed_count; ++k) {
    const LinkPoint<Real>& point = table.pushed_points[k];
    if (!is_on_world<Table>(point.link)) {
      const Real* const force = &table.f_ext[6 * k];
      LinkAxes<Real> axes;
      find_axes(table, motions.poses, point.link, axes);
      Spatial<Real> wrench;
      clear_spatial(wrench);
      for (int j = 0; j < 3; ++j) {
        Real e[3];
        find_direction(point, axes, j, e);
        for (int m = 0; m < 3; ++m) {
          wrench.linear[m] = wrench.linear[m] - (e[m] * force[j]);
          wrench.angular[m] = wrench.angular[m] - (e[m] * force[3 + j]);
        }
      }
      add_cross(point.p, wrench.linear, wrench.angular);
      add(wrench, motions.wrenches[point.link]);
    }
  }
}

/// The wrench on the point's link of a force, or moment, along row `r`.
template <class Table, class Rows, class Real>
void find_unit_force(const Table& table, const Rows& rows, int r, Spatial<Real>& wrench) noexcept {
  const PointRow& row = table.point_rows[r];
  const LinkPoint<Real>& point = table.points[row.point];
  clear_spatial(wrench);
  if (row.angular) {
    find_direction(point, rows.link_axes[row.point], row.axis, wrench.angular);
  } else {
    find_direction(point, rows.link_axes[row.point], row.axis, wrench.linear);
    add_cross(point.p, wrench.linear, wrench.angular);
  }
}

/// Adds to row `r` of Lambda^-1, from column `first` on, `scaled` times the work of the other rows,
/// which `errors` has.
template <class Table, class Real, class Rows>
TREELINE_LINK_INLINE void add_work(const Table& table, const Real& scaled, int first, int r,
                                   Rows& rows) noexcept {
  Real* const sums = &rows.Lambda_inv[r * table.rows];
  int s = first;
  do {
    sums[s] = sums[s] + (scaled * rows.errors[s]);
    ++s;
  } while (s <= r);
}

/// Lambda^-1 += K^T IA^-1 K for the unit forces that have got to a floating base, link `i`.
template <class Table, class Inertias, class Rows, class Real = typename Table::Real>
void absorb_in_base(const Table& table, int i, const Inertias& inertias, Rows& rows) noexcept {
  for (int r = 0; r < table.rows; ++r) {
    Spatial<Real>& K = rows.forces[r];
    if (rows.links[r] == i) {
      Real x[6];
      for (int m = 0; m < 3; ++m) {
        x[m] = K.linear[m];
        x[m + 3] = K.angular[m];
      }
      solve_lower(&inertias.base[0], 6, x);
      for (int m = 0; m < 3; ++m) {
        K.linear[m] = x[m];
        K.angular[m] = x[m + 3];
      }
    } else {
      clear_spatial(K);
    }
  }
  for (int m = 0; m < 6; ++m) {
    for (int r = 0; r < table.rows; ++r) {
      const Spatial<Real>& K = rows.forces[r];
      rows.errors[r] = (m < 3) ? K.linear[m] : K.angular[m - 3];
      add_work(table, rows.errors[r] * inertias.base[7 * m], 0, r, rows);
    }
  }
}

/// Lambda^-1 gains what the forces that have got to link `i` do on its joint, which passes the rest
/// of them on. `errors` has the work of each row, 0 of one that has not got there.
template <class Table, class Motions, class Real, class Rows>
void absorb_in_joint(const Table& table, int i, const Motions& motions,
                     const LinkProjection<Real>& joint, Rows& rows) noexcept {
  Real p[3];
  find_origin(table, i, motions.poses, p);
  LinkTurns<Real> turns;
  find_turns(table.links[i], motions.poses.joints[i], turns);
  Spatial<Real> u;
  copy_spatial(joint.u, u);
  const Real inverse_D = joint.inverse_D;
  const Real held = rotor_of(table, i) * inverse_D;
  int first = table.rows;
  for (int r = 0; r < table.rows; ++r) {
    rows.errors[r] = Real(0.0);
    if (rows.links[r] == i) {
      if (r < first) {
        first = r;
      }
      Spatial<Real> K;
      copy_spatial(rows.forces[r], K);
      const Real along = along_joint(table, i, K);
      rows.errors[r] = along;
      add_work(table, along * inverse_D, first, r, rows);
      add_scaled(u, -along, K);
      along_joint(table, i, K) = held * along;
      if (turns_freely(table, i)) {
        turn_by(rotation_of(table, i, motions.poses), K.linear);
        turn_by(rotation_of(table, i, motions.poses), K.angular);
      } else {
        turn_by_planes(turns, K.linear);
        turn_by_planes(turns, K.angular);
      }
      add_cross(p, K.linear, K.angular);
      copy_spatial(K, rows.forces[r]);
      rows.links[r] = table.links[i].parent;
    }
  }
}

/// The lower triangle of Lambda^-1, the sum over joints of (S^T K)^T D^-1 (S^T K) with the unit
/// forces K of the rows propagated inward (PV-OSIM), once `inertias` is articulated. Uses `errors`.
template <class Table, class Motions, class Inertias, class Rows, class Real = typename Table::Real>
void propagate_forces(const Table& table, const Motions& motions, const Inertias& inertias,
                      Rows& rows) noexcept {
  for (int k = 0; k < (table.rows * table.rows); ++k) {
    rows.Lambda_inv[k] = Real(0.0);
  }
  for (int r = 0; r < table.rows; ++r) {
    find_unit_force(table, rows, r, rows.forces[r]);
    rows.links[r] = table.points[table.point_rows[r].point].link;
  }
  for (int i = table.count - 1; i >= 0; --i) {
    if (is_floating<Table>(i)) {
      absorb_in_base(table, i, inertias, rows);
    } else {
      absorb_in_joint(table, i, motions, inertias.projections[i], rows);
    }
  }
}

/// The joint forces of the unit force of row `r`: a row of the Jacobian.
template <class Table, class Motions, class Rows, class Real>
void find_joint_forces(const Table& table, const Motions& motions, const Rows& rows, int r,
                       Real* forces) noexcept {
  for (int k = 0; k < velocity_at<Table>(count_joints(table)); ++k) {
    forces[k] = Real(0.0);
  }
  Spatial<Real> wrench;
  find_unit_force(table, rows, r, wrench);
  for (int i = table.points[table.point_rows[r].point].link; i >= 0; i = table.links[i].parent) {
    if (is_floating<Table>(i)) {
      for (int k = 0; k < 3; ++k) {
        forces[k] = wrench.linear[k];
        forces[k + 3] = wrench.angular[k];
      }
    } else {
      const int at = velocity_at<Table>(joint_of(table, i));
      forces[at] = forces[at] + scale(table, i, along_joint(table, i, wrench));
      wrench_to_parent(table, i, motions.poses, wrench);
    }
  }
}

/// The lower triangle of Lambda^-1 = Y D^-1 Y^T, Y^T = L^-1 J^T, once M is factored to L D L^T.
template <class Table, class Motions, class Inertias, class Rows, class Real = typename Table::Real>
void project_rows(const Table& table, const Motions& motions, Inertias& inertias,
                  Rows& rows) noexcept {
  const int nv = velocity_at<Table>(count_joints(table));
  for (int r = 0; r < table.rows; ++r) {
    Real* const own = &inertias.base[nv * (nv + r)];
    find_joint_forces(table, motions, rows, r, own);
    solve_lower(&inertias.base[0], nv, own);
    for (int s = 0; s <= r; ++s) {
      const Real* const other = &inertias.base[nv * (nv + s)];
      Real sum = Real(0.0);
      for (int k = 0; k < nv; ++k) {
        sum = sum + ((own[k] * inertias.base[(nv + 1) * k]) * other[k]);
      }
      rows.Lambda_inv[(r * table.rows) + s] = sum;
    }
  }
}

/// Lambda^-1 from its lower triangle.
template <class Table, class Real, class Rows>
void copy_lambda_inverse(const Table& table, const Rows& rows, Real* Lambda_inv) noexcept {
  const int n = table.rows;
  for (int r = 0; r < n; ++r) {
    const int row = entry_of(table, r);
    for (int s = 0; s <= r; ++s) {
      const int column = entry_of(table, s);
      Lambda_inv[(column * n) + row] = rows.Lambda_inv[(r * n) + s];
      Lambda_inv[(row * n) + column] = rows.Lambda_inv[(r * n) + s];
    }
  }
}

/// Lambda from the lower triangle of Lambda^-1, which is lost. Rows are eliminated in the order of
/// results: the last of those that depend on each other yield. For `power` and `yields` see
/// `factor`.
template <int power, class Table, class Real, class Rows>
void invert_rows(const Table& table, const Real* yields, Rows& rows, Real* Lambda) noexcept {
  const int n = table.rows;
  if constexpr (Table::kSorted) {
    copy_lambda_inverse(table, rows, Lambda);
    for (int k = 0; k < (n * n); ++k) {
      rows.Lambda_inv[k] = Lambda[k];
    }
  }
  factor<power>(&rows.Lambda_inv[0], n, yields);
  invert_lower(&rows.Lambda_inv[0], n);
  multiply_inverses(&rows.Lambda_inv[0], n, Lambda);
}

/// 1 over the border of each row in the order of priority: 2^-13 of the inverse inertia, of which
/// the lower triangle is read, that its point has to translation, or to rotation, and of `floors`
/// more. That is a sum over the point's rows.
template <class Table, class Real, class Rows>
void find_inverse_borders(const Table& table, const Real* floors, Rows& rows) noexcept {
  for (int r = 0; r < table.rows; ++r) {
    const PointRow& row = table.point_rows[r];
    Real mobility = floors[r];
    for (int s = 0; s < table.rows; ++s) {
      const PointRow& other = table.point_rows[s];
      if ((other.point == row.point) && (other.angular == row.angular)) {
        mobility = mobility + rows.Lambda_inv[(table.rows + 1) * s];
      }
    }
    rows.inverse_borders[r] = Real(8192.0) / mobility;
  }
}

/// xdd_cmd - (Jd qd + J qdd_0), from the motions of the points.
template <class Table, class Real, class Rows>
void find_errors(const Table& table, const Real* xdd_cmd, Rows& rows) noexcept {
  for (int r = 0; r < table.rows; ++r) {
    const PointRow& row = table.point_rows[r];
    const LinkPoint<Real>& point = table.points[row.point];
    const LinkMotion<Real>& motion = rows.point_motions[row.point];
    Real e[3];
    find_direction(point, rows.link_axes[row.point], row.axis, e);
    Real moved[3];
    for (int j = 0; j < 3; ++j) {
      const Real* const own = &rows.link_axes[row.point].rows[3 * j];
      const Real weight =
          (own[0] * table.gravity[0]) + (own[1] * table.gravity[1]) + (own[2] * table.gravity[2]);
      moved[j] = row.angular ? motion.wd[j] : (motion.a[j] + weight);
    }
    if (!row.angular) {
      add_rotation(motion, point.p, moved);
    }
    rows.errors[r] = xdd_cmd[entry_of(table, r)] - dot(e, moved);
  }
}

/// The power of a wrench on a link, in its axes, as the robot moves at qd. Loses the wrench.
template <class Table, class Motions, class Real>
Real find_power(const Table& table, const Motions& motions, int link, const Real* qd,
                Spatial<Real>& wrench) noexcept {
  Real power = Real(0.0);
  for (int i = link; i >= 0; i = table.links[i].parent) {
    if (is_floating<Table>(i)) {
      for (int k = 0; k < 3; ++k) {
        power = power + (wrench.linear[k] * qd[k]) + (wrench.angular[k] * qd[k + 3]);
      }
    } else {
      const int at = velocity_at<Table>(joint_of(table, i));
      power = power + (scale(table, i, along_joint(table, i, wrench)) * qd[at]);
      wrench_to_parent(table, i, motions.poses, wrench);
    }
  }
  return power;
}

/// Makes of the errors of linear rows e in axes that turn with their link those of the rates of
/// their velocities, which are less than accelerations by e . (w x v): the power of a force e x w
/// at the point.
template <class Table, class Motions, class Real, class Rows>
void count_in_turning_axes(const Table& table, const Motions& motions, const Real* qd,
                           Rows& rows) noexcept {
  for (int r = 0; r < table.rows; ++r) {
    const PointRow& row = table.point_rows[r];
    const LinkPoint<Real>& point = table.points[row.point];
    if (!point.world && !row.angular && !is_on_world<Table>(point.link)) {
      const LinkMotion<Real>& motion = rows.point_motions[row.point];
      Real e[3];
      find_direction(point, rows.link_axes[row.point], row.axis, e);
      Spatial<Real> wrench;
      clear_spatial(wrench);
      add_cross(e, motion.w, wrench.linear);
      add_cross(point.p, wrench.linear, wrench.angular);
      rows.errors[r] = rows.errors[r] + find_power(table, motions, point.link, qd, wrench);
    }
  }
}

/// Adds the wrenches of forces along the rows to those of links: J^T F.
template <class Table, class Motions, class Rows, class Real = typename Table::Real>
void add_row_forces(const Table& table, const Rows& rows, Motions& motions) noexcept {
  for (int r = 0; r < table.rows; ++r) {
    const int link = table.points[table.point_rows[r].point].link;
    if (!is_on_world<Table>(link)) {
      Spatial<Real> wrench;
      find_unit_force(table, rows, r, wrench);
      for (int k = 0; k < 3; ++k) {
        wrench.linear[k] = wrench.linear[k] * rows.errors[r];
        wrench.angular[k] = wrench.angular[k] * rows.errors[r];
      }
      add(wrench, motions.wrenches[link]);
    }
  }
}

}  // namespace treeline::core::loops
