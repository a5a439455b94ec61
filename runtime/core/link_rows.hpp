#pragma once
// Functions of operational points by loops over a table of links: Lambda^-1, Lambda, control
// torque. C++17, freestanding.

#include "core/link_inertia.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::loops {

template <class Real, int points, int rows>
struct RowWork {
  LinkAxes<Real> link_axes[points];  ///< of the points' links
  Spatial<Real> forces[rows];        ///< unit forces on their way to the base
  short links[rows];                 ///< where they have got to
  Real errors[rows];
  Real Lambda_inv[rows * rows];
};

/// Calls `visit(row, point, axis, angular)` for each row of the points.
template <class Table, class Visit>
void for_each_row(const Table& table, const Visit& visit) noexcept {
  int row = 0;
  for (int p = 0; p < table.point_count; ++p) {
    for (int k = 0; k < 6; ++k) {
      if (!table.points[p].rows[k]) continue;
      visit(row, p, k % 3, k >= 3);
      ++row;
    }
  }
}

template <class Table, class Motions, class Work>
void find_point_axes(const Table& table, const Motions& motions, Work& work) noexcept {
  for (int p = 0; p < table.point_count; ++p) {
    find_axes(table, &motions.poses[0], motions.base, table.points[p].link, work.link_axes[p]);
  }
}

/// The direction of a row in the axes of the point's link.
template <class Real>
void find_direction(const LinkPoint<Real>& point, const LinkAxes<Real>& link_axes, int axis,
                    Real (&e)[3]) noexcept {
  for (int j = 0; j < 3; ++j) {
    e[j] = point.world ? link_axes.rows[3 * j + axis] : point.axes[3 * axis + j];
  }
}

/// The wrench on the point's link of a force, or moment, along a row.
template <class Real>
void find_unit_force(const LinkPoint<Real>& point, const LinkAxes<Real>& link_axes, int axis,
                     bool angular, Spatial<Real>& wrench) noexcept {
  clear(wrench);
  if (angular) {
    find_direction(point, link_axes, axis, wrench.angular);
  } else {
    find_direction(point, link_axes, axis, wrench.linear);
    add_cross(point.p, wrench.linear, wrench.angular);
  }
}

/// Lambda^-1 += work D^-1 work^T of a joint, for the rows that have got to link `i`.
template <class Table, class Real, class Work>
void absorb(const Table& table, int i, const Real* work_of_rows, const Real& inverse_D,
            Work& work) noexcept {
  for (int r = 0; r < table.rows; ++r) {
    if (work.links[r] != i) continue;
    const Real scaled = work_of_rows[r] * inverse_D;
    for (int s = 0; s <= r; ++s) {
      if (work.links[s] != i) continue;
      Real& sum = work.Lambda_inv[r * table.rows + s];
      sum = sum + scaled * work_of_rows[s];
    }
  }
}

/// Lambda^-1 += K^T IA^-1 K for the unit forces that have got to a floating base.
template <class Table, class Inertias, class Work, class Real = typename Table::Real>
void absorb_in_base(const Table& table, const Inertias& inertias, Work& work) noexcept {
  for (int r = 0; r < table.rows; ++r) {
    if (work.links[r] != 0) continue;
    Spatial<Real>& K = work.forces[r];
    Real x[6];
    for (int k = 0; k < 3; ++k) {
      x[k] = K.linear[k];
      x[k + 3] = K.angular[k];
    }
    solve_lower(&inertias.base[0], 6, x);
    for (int k = 0; k < 3; ++k) {
      K.linear[k] = x[k];
      K.angular[k] = x[k + 3];
    }
  }
  for (int k = 0; k < 6; ++k) {
    for (int r = 0; r < table.rows; ++r) {
      work.errors[r] = k < 3 ? work.forces[r].linear[k] : work.forces[r].angular[k - 3];
    }
    absorb(table, 0, &work.errors[0], inertias.base[7 * k], work);
  }
}

/// The lower triangle of Lambda^-1, the sum over joints of (S^T K)^T D^-1 (S^T K) with the unit
/// forces K of the rows propagated inward (PV-OSIM), once `inertias` is articulated. Uses `errors`.
template <class Table, class Motions, class Inertias, class Work, class Real = typename Table::Real>
void propagate_forces(const Table& table, const Motions& motions, const Inertias& inertias,
                      Work& work) noexcept {
  for (int k = 0; k < table.rows * table.rows; ++k) work.Lambda_inv[k] = Real(0.0);
  for_each_row(table, [&](int row, int p, int axis, bool angular) {
    find_unit_force(table.points[p], work.link_axes[p], axis, angular, work.forces[row]);
    work.links[row] = table.points[p].link;
  });
  for (int i = table.count - 1; i >= 0; --i) {
    if (Table::is_floating(i)) {
      absorb_in_base(table, inertias, work);
      continue;
    }
    const LinkProjection<Real>& joint = inertias.projections[i];
    for (int r = 0; r < table.rows; ++r) {
      work.errors[r] = along_joint(table, i, work.forces[r]);
    }
    absorb(table, i, &work.errors[0], joint.inverse_D, work);
    for (int r = 0; r < table.rows; ++r) {
      if (work.links[r] != i) continue;
      Spatial<Real>& K = work.forces[r];
      const Real along = work.errors[r];
      for (int k = 0; k < 3; ++k) {
        K.linear[k] = K.linear[k] - joint.u.linear[k] * along;
        K.angular[k] = K.angular[k] - joint.u.angular[k] * along;
      }
      along_joint(table, i, K) = table.links[i].rotor * joint.inverse_D * along;
      to_parent(table, i, motions.poses[i], K);
      work.links[r] = table.links[i].parent;
    }
  }
}

/// Lambda^-1 from its lower triangle.
template <class Table, class Real, class Work>
void copy_lambda_inverse(const Table& table, const Work& work, Real* Lambda_inv) noexcept {
  const int n = table.rows;
  for (int r = 0; r < n; ++r) {
    for (int s = 0; s <= r; ++s) {
      Lambda_inv[r * n + s] = Lambda_inv[s * n + r] = work.Lambda_inv[r * n + s];
    }
  }
}

/// Lambda from the lower triangle of Lambda^-1, which is lost. For `power` and `yields` see
/// `factor`.
template <int power, class Table, class Real, class Work>
void invert_rows(const Table& table, const Real* yields, Work& work, Real* Lambda) noexcept {
  const int n = table.rows;
  factor<power>(&work.Lambda_inv[0], n, yields);
  for (int s = 0; s < n; ++s) {
    for (int r = 0; r < n; ++r) work.errors[r] = Real(r == s ? 1.0 : 0.0);
    solve(&work.Lambda_inv[0], n, &work.errors[0]);
    for (int r = s; r < n; ++r) Lambda[r * n + s] = Lambda[s * n + r] = work.errors[r];
  }
}

/// xdd_cmd - (Jd qd + J qdd_0), from the motions of the points.
template <class Table, class Real, class Motions, class Work>
void find_errors(const Table& table, const Real* xdd_cmd, const Motions& motions,
                 Work& work) noexcept {
  for_each_row(table, [&](int row, int p, int axis, bool angular) {
    const LinkPoint<Real>& point = table.points[p];
    const LinkMotion<Real>& motion = motions.point_motions[p];
    Real e[3];
    find_direction(point, work.link_axes[p], axis, e);
    Real moved[3];
    for (int j = 0; j < 3; ++j) {
      const Real* const own = &work.link_axes[p].rows[3 * j];
      const Real weight =
          own[0] * table.gravity[0] + own[1] * table.gravity[1] + own[2] * table.gravity[2];
      moved[j] = angular ? motion.wd[j] : motion.a[j] + weight;
    }
    if (!angular) add_rotation(motion, point.p, moved);
    work.errors[row] = xdd_cmd[row] - dot(e, moved);
  });
}

/// Adds the wrenches of forces along the rows to those of links: J^T F.
template <class Table, class Motions, class Work>
void add_row_forces(const Table& table, const Work& work, Motions& motions) noexcept {
  using Real = typename Table::Real;
  for_each_row(table, [&](int row, int p, int axis, bool angular) {
    Spatial<Real> wrench;
    find_unit_force(table.points[p], work.link_axes[p], axis, angular, wrench);
    for (int k = 0; k < 3; ++k) {
      wrench.linear[k] = wrench.linear[k] * work.errors[row];
      wrench.angular[k] = wrench.angular[k] * work.errors[row];
    }
    add(wrench, motions.wrenches[table.points[p].link]);
  });
}

}  // namespace treeline::core::loops

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
