#pragma once
// Functions of a robot by loops over a table of its links, with the arguments of the
// generated functions. No heap, no branch on anything but the table: a robot's
// functions take the same instructions for every input. What is in their work space
// before is not read.
//
// This is small code: `optimize: size`. Straight lines are several times as fast,
// since they leave out what is zero. Frames, units and the order of joints are those
// of the generated code.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sin_cos.h"

/// Joint forces of the wrenches that move links, less those of external forces.
TL_INLINE void tl_gather_all_forces(const TlLinkTable* table, const real* q,
    const real* qd, const real* qdd, TlMotionWork* motions, real* tau) {
  if (TL_PUSHED) {
    if (table->f_ext != TL_NONE) {
      tl_take_external_forces(table, motions);
    }
  }
  tl_gather_forces(table, q, qd, qdd, motions, tau);
}

/// tau = M qdd + b + g - J_ext^T f_ext
TL_INLINE void tl_inverse_dynamics(const TlLinkTable* table, const real* q,
    const real* qd, const real* qdd, real* tau, TlMotionWork* motions) {
  TlLinkMotion* const no_points = TL_NONE;
  tl_place_links(table, q, &motions->poses);
  tl_move_links(table, qd, qdd, motions, no_points);
  tl_gather_all_forces(table, q, qd, qdd, motions, tau);
}

TL_INLINE void tl_nonlinear_effects(const TlLinkTable* table, const real* q,
    const real* qd, real* h, TlMotionWork* motions) {
  const real* const none = TL_NONE;
  tl_inverse_dynamics(table, q, qd, none, h, motions);
}

TL_INLINE void tl_gravity(
    const TlLinkTable* table, const real* q, real* g, TlMotionWork* motions) {
  const real* const none = TL_NONE;
  tl_inverse_dynamics(table, q, none, none, g, motions);
}

TL_INLINE void tl_mass_matrix(const TlLinkTable* table, const real* q, real* M,
    TlMotionWork* motions, TlMatrixWork* matrices) {
  tl_place_links(table, q, &motions->poses);
  tl_find_mass_matrix(table, motions, matrices, M);
}

/// qdd = M^-1 (tau - b - g + J_ext^T f_ext), by factors of M where joints share
/// coordinates.
TL_INLINE void tl_forward_dynamics(const TlLinkTable* table, const real* q,
    const real* qd, const real* tau, real* qdd, TlMotionWork* motions,
    TlFactorWork* inertias) {
  const real* const none = TL_NONE;
  tl_inverse_dynamics(table, q, qd, none, qdd, motions);
  if (TL_COUPLED) {
    tl_factor_mass_matrix(table, motions, inertias);
    tl_solve_accelerations(table, tau, inertias, qdd);
  } else {
    tl_articulate(table, motions, inertias);
    tl_find_accelerations(table, tau, motions, inertias, qdd);
  }
}

/// The lower triangle of Lambda^-1 to `rows`, once links are placed.
TL_SHARED void tl_find_lambda_inverse(const TlLinkTable* table, TlMotionWork* motions,
    TlFactorWork* inertias, TlRowWork* rows) {
  tl_find_point_axes(table, motions, rows);
  if (TL_COUPLED) {
    tl_factor_mass_matrix(table, motions, inertias);
    tl_project_rows(table, motions, inertias, rows);
  } else {
    tl_articulate(table, motions, inertias);
    tl_propagate_forces(table, motions, inertias, rows);
  }
}

TL_INLINE void tl_lambda_inverse(const TlLinkTable* table, const real* q,
    real* Lambda_inv, TlMotionWork* motions, TlFactorWork* inertias,
    TlRowWork* rows) {
  tl_place_links(table, q, &motions->poses);
  tl_find_lambda_inverse(table, motions, inertias, rows);
  tl_copy_lambda_inverse(table, rows, Lambda_inv);
}

/// For `power` and `yields` see `tl_factor`.
TL_INLINE void tl_lambda(int32_t power, const TlLinkTable* table, const real* yields,
    const real* q, real* Lambda, TlMotionWork* motions, TlFactorWork* inertias,
    TlRowWork* rows) {
  tl_place_links(table, q, &motions->poses);
  tl_find_lambda_inverse(table, motions, inertias, rows);
  tl_invert_rows(power, table, yields, rows, Lambda);
}

/// tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
/// qdd_0). `yields` are those of `tl_factor`; with power 8, of rows in the order of
/// priority, those of `tl_find_inverse_borders`.
TL_INLINE void tl_control_torque(int32_t power, const TlLinkTable* table,
    const real* yields, const real* q, const real* qd, const real* qdd_0,
    const real* xdd_cmd, real* tau, TlMotionWork* motions, TlFactorWork* inertias,
    TlRowWork* rows) {
  tl_place_links(table, q, &motions->poses);
  tl_move_links(table, qd, qdd_0, motions, &rows->point_motions[0]);
  tl_find_lambda_inverse(table, motions, inertias, rows);
  tl_find_errors(table, xdd_cmd, rows);
  if (TL_TURNING) {
    tl_count_in_turning_axes(table, motions, qd, rows);
  }
  const real* borders = yields;
  if (power == 8) {
    tl_find_inverse_borders(table, yields, rows);
    borders = &rows->inverse_borders[0];
  }
  tl_factor(power, &rows->Lambda_inv[0], table->rows, borders);
  tl_solve(&rows->Lambda_inv[0], table->rows, &rows->errors[0]);
  tl_add_row_forces(table, rows, motions);
  tl_gather_all_forces(table, q, qd, qdd_0, motions, tau);
}
