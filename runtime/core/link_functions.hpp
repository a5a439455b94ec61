#pragma once
// Functions of a robot by loops over a table of its links, with the arguments of the generated
// functions. What is in their work space before is not read. C++17, freestanding.

#include "core/link_rows.hpp"

namespace treeline::core::loops {

/// Joint forces of the wrenches that move links, less those of external forces.
template <class Table, class Real, class Motions>
void gather_all_forces(const Table& table, const Real* q, const Real* qd, const Real* qdd,
                       Motions& motions, Real* tau) noexcept {
  if constexpr (Table::kPushed) {
    if (table.f_ext != nullptr) {
      take_external_forces(table, motions);
    }
  }
  gather_forces(table, q, qd, qdd, motions, tau);
}

/// tau = M qdd + b + g - J_ext^T f_ext
template <class Table, class Real, class Sines, class Motions>
void inverse_dynamics(const Table& table, const Real* q, const Sines& sines, const Real* qd,
                      const Real* qdd, Real* tau, Motions& motions) noexcept {
  LinkMotion<Real>* const no_points = nullptr;
  place_links(table, q, sines, motions.poses);
  move_links(table, qd, qdd, motions, no_points);
  gather_all_forces(table, q, qd, qdd, motions, tau);
}

template <class Table, class Real, class Sines, class Motions>
void nonlinear_effects(const Table& table, const Real* q, const Sines& sines, const Real* qd,
                       Real* h, Motions& motions) noexcept {
  const Real* const none = nullptr;
  inverse_dynamics(table, q, sines, qd, none, h, motions);
}

template <class Table, class Real, class Sines, class Motions>
void gravity(const Table& table, const Real* q, const Sines& sines, Real* g,
             Motions& motions) noexcept {
  const Real* const none = nullptr;
  inverse_dynamics(table, q, sines, none, none, g, motions);
}

template <class Table, class Real, class Sines, class Motions, class Matrices>
void mass_matrix(const Table& table, const Real* q, const Sines& sines, Real* M, Motions& motions,
                 Matrices& matrices) noexcept {
  place_links(table, q, sines, motions.poses);
  find_mass_matrix(table, motions, matrices, M);
}

/// qdd = M^-1 (tau - b - g + J_ext^T f_ext), by factors of M where joints share coordinates.
template <class Table, class Real, class Sines, class Motions, class Inertias>
void forward_dynamics(const Table& table, const Real* q, const Sines& sines, const Real* qd,
                      const Real* tau, Real* qdd, Motions& motions, Inertias& inertias) noexcept {
  nonlinear_effects(table, q, sines, qd, qdd, motions);
  if constexpr (Table::kCoupled) {
    factor_mass_matrix(table, motions, inertias);
    solve_accelerations(table, tau, inertias, qdd);
  } else {
    articulate(table, motions, inertias);
    find_accelerations(table, tau, motions, inertias, qdd);
  }
}

/// The lower triangle of Lambda^-1 to `rows`, once links are placed.
template <class Table, class Motions, class Inertias, class Rows, class Real = typename Table::Real>
TREELINE_LINK_SHARED void find_lambda_inverse(const Table& table, Motions& motions,
                                              Inertias& inertias, Rows& rows) noexcept {
  find_point_axes(table, motions, rows);
  if constexpr (Table::kCoupled) {
    factor_mass_matrix(table, motions, inertias);
    project_rows(table, motions, inertias, rows);
  } else {
    articulate(table, motions, inertias);
    propagate_forces(table, motions, inertias, rows);
  }
}

template <class Table, class Real, class Sines, class Motions, class Inertias, class Rows>
void lambda_inverse(const Table& table, const Real* q, const Sines& sines, Real* Lambda_inv,
                    Motions& motions, Inertias& inertias, Rows& rows) noexcept {
  place_links(table, q, sines, motions.poses);
  find_lambda_inverse(table, motions, inertias, rows);
  copy_lambda_inverse(table, rows, Lambda_inv);
}

/// For `power` and `yields` see `factor`.
template <int power, class Table, class Real, class Sines, class Motions, class Inertias,
          class Rows>
void lambda(const Table& table, const Real* yields, const Real* q, const Sines& sines, Real* Lambda,
            Motions& motions, Inertias& inertias, Rows& rows) noexcept {
  place_links(table, q, sines, motions.poses);
  find_lambda_inverse(table, motions, inertias, rows);
  invert_rows<power>(table, yields, rows, Lambda);
}

/// tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0). `yields`
/// are those of `factor`; with power 8, of rows in the order of priority, those of
/// `find_inverse_borders`.
template <int power, class Table, class Real, class Sines, class Motions, class Inertias,
          class Rows>
void control_torque(const Table& table, const Real* yields, const Real* q, const Sines& sines,
                    const Real* qd, const Real* qdd_0, const Real* xdd_cmd, Real* tau,
                    Motions& motions, Inertias& inertias, Rows& rows) noexcept {
  place_links(table, q, sines, motions.poses);
  move_links(table, qd, qdd_0, motions, &rows.point_motions[0]);
  find_lambda_inverse(table, motions, inertias, rows);
  find_errors(table, xdd_cmd, rows);
  if constexpr (Table::kTurning) {
    count_in_turning_axes(table, motions, qd, rows);
  }
  const Real* borders = yields;
  if constexpr (power == 8) {
    find_inverse_borders(table, yields, rows);
    borders = &rows.inverse_borders[0];
  }
  factor<power>(&rows.Lambda_inv[0], table.rows, borders);
  solve(&rows.Lambda_inv[0], table.rows, &rows.errors[0]);
  add_row_forces(table, rows, motions);
  gather_all_forces(table, q, qd, qdd_0, motions, tau);
}

}  // namespace treeline::core::loops
