#pragma once
// Torques of motors within their limits, forces of supports within their friction
// cones. No heap, a stated bound on the work.
//
// tau and f of an unlimited law obey M qdd + h = S^T tau + J_s^T f and J_s qdd + Jd_s
// qd = 0. All that can be changed about them keeps both:
//
//     M d_qdd = S^T d_tau + J_s^T d_f,   J_s d_qdd = 0.
//
// Of all changes that bring tau and f within their limits, the one of least cost is
// taken:
//
//     1/2 k^2 |d_xdd|^2_D + 1/2 d_qdd^T M d_qdd + 1/2 |d_z|^2 / (k^2 m) +
//     penalty(slack)
//
// d_xdd = J_t d_qdd is what the task loses, D its effective masses, z the forces that
// carry nothing (internal forces of two feet). k is large, so that forces give way
// first, then the posture, then the task. Where no limit is reached nothing is
// changed, to the bit.

#include "limit_program.h"

TL_INLINE bool tl_is_passive(const TlSupportLayout* layout, int32_t velocity) {
  bool passive = false;
  for (int32_t j = 0; j < TL_PASSIVE; ++j) {
    passive = passive || (layout->passive[j] == velocity);
  }
  return passive;
}

TL_INLINE real tl_clipped(real x, real most) {
  const real below = (x < -most) ? -most : x;
  return (x > most) ? most : below;
}

/// Sums are formed in arrays of their own, which nothing else can change.
TL_INLINE void tl_copy_row(const real* from, real* to) {
  for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
    to[n] = from[n];
  }
}

#if TL_SHARES
/// The layout with every row whole.
TL_INLINE void tl_take_whole(const TlSupportLayout* whole, TlSupportLayout* layout) {
  for (int32_t j = 0; j < TL_PASSIVE_ENTRIES; ++j) {
    layout->passive[j] = whole->passive[j];
  }
  for (int32_t h = 0; h < TL_HELD_ENTRIES; ++h) {
    layout->force_weights[h] = whole->force_weights[h];
    layout->share_of[h] = whole->share_of[h];
    layout->shares[h] = TL_ONE;
  }
  for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
    layout->share_of_task[t] = whole->share_of_task[t];
    layout->task_weights[t] = TL_ONE;
  }
}

/// Bounds of cones are those of supports that are held whole, times their share.
TL_INLINE real tl_bound_of(const TlSupportLayout* layout, const TlConeRow* cone) {
  return layout->shares[cone->first] * cone->bound;
}

/// The row of a cone of a support held to the share w, which is widened w^-7 times as
/// much as others: forces there are w-fold, and their cone must not rule the motion
/// to the last. Where it all but depends on the bound of the slack it is left out.
TL_INLINE void tl_share_cone(const TlSupportLayout* layout, TlLimitProgram* program,
    const TlConeRow* cone, int32_t row) {
  const real share = layout->shares[cone->first];
  const real square = share * share;
  const real scale = (square * square) * (square * share);
  const real room =
      program->rows.upper[row] - (cone->bound - tl_bound_of(layout, cone));
  for (int32_t n = 0; n < TL_FREEDOMS; ++n) {
    program->rows.A[(row * TL_UNKNOWNS) + n] *= scale;
  }
  const bool counts = scale > TL_LEAST_CONE;
  program->rows.upper[row] = counts ? (scale * room) : TL_NO_LIMIT;
}

/// Rows held to the shares `active`, or whole: forces that are held less give way
/// first, and vanish with their shares.
TL_INLINE void tl_share_supports(const real* active, TlSupportLayout* layout) {
  for (int32_t h = 0; h < TL_HELD_ENTRIES; ++h) {
    const int32_t of = layout->share_of[h];
    if (of >= 0) {
      layout->shares[h] = (active[of] > TL_ZERO) ? active[of] : TL_ZERO;
      layout->force_weights[h] *= tl_root(layout->shares[h]);
    }
  }
}

/// Tasks done to the shares `active`, which weigh s^8 of those that are done whole:
/// from level to level of the cost in steps that no share takes at once.
TL_INLINE void tl_share_tasks(const real* active, TlSupportLayout* layout) {
  for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
    const int32_t of = layout->share_of_task[t];
    if (of >= 0) {
      const real square = active[of] * active[of];
      layout->task_weights[t] = (square * square) * (square * square);
    }
  }
}

#endif
/// Rows of cones, and the slack with its penalty c s + c / (2 m g) s^2: c is above
/// any multiplier of the rows that costs of the task give rise to, per N.
TL_INLINE void tl_add_cones(
    TlLimitProgram* program, const TlTorqueLimits* limits, const real* f) {
  const real weight = TL_TEN * program->heaviest;
  program->slack = tl_root(weight / TL_SLACK_PENALTY);
  for (int32_t c = 0; c < TL_CONES; ++c) {
    const TlConeRow* const cone = &limits->cones[c];
    real a[TL_UNKNOWNS];
    real room = cone->bound;
    for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
      a[n] = TL_ZERO;
    }
    for (int32_t k = 0; k < cone->count; ++k) {
      const real factor = cone->coefficients[k];
      room -= factor * f[cone->first + k];
      for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
        a[n] += factor * program->forces[((cone->first + k) * TL_UNKNOWNS) + n];
      }
    }
    a[TL_FREEDOMS] = -program->slack;
    tl_copy_row(&a[0], &program->rows.A[(TL_MOTORS + c) * TL_UNKNOWNS]);
    program->rows.lower[TL_MOTORS + c] = -TL_NO_LIMIT;
    program->rows.upper[TL_MOTORS + c] = room;
  }
  for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
    program->rows.lowest[n] = -TL_NO_LIMIT;
    program->rows.highest[n] = TL_NO_LIMIT;
    program->set.center[n] = TL_ZERO;
  }
  program->rows.lowest[TL_FREEDOMS] = TL_ZERO;
  program->set.center[TL_FREEDOMS] = -weight / program->slack;
}

/// Rows of the torques' and cones' changes, and what is left to the limits.
TL_INLINE void tl_limit_rows(const TlSupportLayout* layout, TlLimitProgram* program,
    const TlTorqueLimits* limits, const real* J_s, const real* tau, const real* f) {
  int32_t row = 0;
  for (int32_t v = 0; v < TL_VELOCITIES; ++v) {
    if (!tl_is_passive(layout, v)) {
      real a[TL_UNKNOWNS];
      tl_read_column(program, v, &a[0]);
      for (int32_t h = 0; h < TL_HELD_ROWS; ++h) {
        const real factor = J_s[(h * TL_VELOCITIES) + v];
        if (factor != TL_ZERO) {
          for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
            a[n] -= factor * program->forces[(h * TL_UNKNOWNS) + n];
          }
        }
      }
      tl_copy_row(&a[0], &program->rows.A[row * TL_UNKNOWNS]);
      program->rows.lower[row] = -limits->torque[v] - tau[v];
      program->rows.upper[row] = limits->torque[v] - tau[v];
      ++row;
    }
  }
  tl_add_cones(program, limits, f);
  if (TL_SHARES) {
    for (int32_t c = 0; c < TL_CONES; ++c) {
      tl_share_cone(layout, program, &limits->cones[c], TL_MOTORS + c);
    }
  }
}

/// tau and f with their changes, and torques within their limits to the last bit.
TL_INLINE void tl_solve_program(const TlSupportLayout* layout,
    TlLimitProgram* program, const TlTorqueLimits* limits, real* tau, real* f,
    TlLimitedTorque* result) {
  TlActiveSet* const set = &program->set;
  for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
    set->sides[row] = result->sides[row];
  }
  tl_start_at_center(set, &program->rows, TL_MOST_ITERATIONS);
  tl_solve_rows(set, &program->rows, result->warm);
  for (int32_t row = 0; row < TL_ALL_ROWS; ++row) {
    result->sides[row] = set->sides[row];
  }
  result->warm = true;
  result->status = set->status;
  result->iterations = set->iterations;
  const real widened = program->slack * set->x[TL_FREEDOMS];
  result->slack = (widened < TL_ZERO) ? TL_ZERO : widened;
  for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
    result->lost[t] = TL_ZERO;
    for (int32_t i = 0; i < program->task; ++i) {
      result->lost[t] -= (program->weights[t] > TL_ZERO)
          ? (program->W[((program->held + i) * TL_COLS) + TL_TASK_AT + t] * set->x[i])
          : TL_ZERO;
    }
  }
  for (int32_t h = 0; h < TL_HELD_ROWS; ++h) {
    f[h] += tl_dot(&program->forces[h * TL_UNKNOWNS], &set->x[0]);
  }
  int32_t row = 0;
  for (int32_t v = 0; v < TL_VELOCITIES; ++v) {
    if (!tl_is_passive(layout, v)) {
      const real change = tl_dot(&program->rows.A[row * TL_UNKNOWNS], &set->x[0]);
      tau[v] = tl_clipped(tau[v] + change, limits->torque[v]);
      ++row;
    }
  }
}

/// Whether all that can be limited is within its limits, but for rounding of cones.
TL_INLINE bool tl_is_within(
#if TL_SHARES
    const TlSupportLayout* layout,
#endif
    const TlTorqueLimits* limits, const real* tau, const real* f) {
  bool within = true;
  for (int32_t v = 0; v < TL_VELOCITIES; ++v) {
    const real size = (tau[v] < TL_ZERO) ? -tau[v] : tau[v];
    within = within && (size <= limits->torque[v]);
  }
  for (int32_t c = 0; c < TL_CONES; ++c) {
    const TlConeRow* const cone = &limits->cones[c];
    real value = TL_ZERO;
    for (int32_t k = 0; k < cone->count; ++k) {
      value += cone->coefficients[k] * f[cone->first + k];
    }
#if TL_SHARES
    within = within && (value <= tl_bound_of(layout, cone));
#else
    within = within && (value <= cone->bound);
#endif
  }
  return within;
}

TL_INLINE void tl_report_unlimited(TlLimitedTorque* result) {
  result->limited = false;
  result->status = TL_SOLVED;
  result->slack = TL_ZERO;
  result->iterations = 0;
  for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
    result->lost[t] = TL_ZERO;
  }
  result->warm = false;
}

TL_INLINE bool tl_all_finite(const real* numbers, int32_t count) {
  bool finite = true;
  for (int32_t i = 0; i < count; ++i) {
    finite = finite && tl_is_finite(numbers[i]);
  }
  return finite;
}

/// Changes tau and f of an unlimited law as little as their limits permit. M is the
/// mass matrix, J_s and J_t are the Jacobians of the held rows and of the task rows.
/// Where numbers do not fit the type torques are clipped only, and the status is
/// TL_NOT_CONVEX.
TL_INLINE void tl_limit_torque(const TlSupportLayout* layout,
    const TlTorqueLimits* limits, const real* M, const real* J_s, const real* J_t,
    real* tau, real* f, TlLimitedTorque* result) {
  TlLimitProgram program;
  real changed_tau[TL_VELOCITIES];
  real changed_f[TL_HELD_ENTRIES];
  for (int32_t v = 0; v < TL_VELOCITIES; ++v) {
    changed_tau[v] = tau[v];
  }
  for (int32_t h = 0; h < TL_HELD_ENTRIES; ++h) {
    changed_f[h] = f[h];
  }
  tl_set_up(layout, &program, limits, M, J_s, J_t);
  tl_limit_rows(layout, &program, limits, J_s, tau, f);
  tl_solve_program(layout, &program, limits, &changed_tau[0], &changed_f[0], result);
  const bool fits = tl_all_finite(&changed_tau[0], TL_VELOCITIES) &&
      tl_all_finite(&changed_f[0], TL_HELD_ENTRIES);
  if (fits) {
    for (int32_t v = 0; v < TL_VELOCITIES; ++v) {
      tau[v] = changed_tau[v];
    }
    for (int32_t h = 0; h < TL_HELD_ENTRIES; ++h) {
      f[h] = changed_f[h];
    }
  } else {
    tl_report_unlimited(result);
    result->status = TL_NOT_CONVEX;
    for (int32_t v = 0; v < TL_VELOCITIES; ++v) {
      tau[v] = tl_clipped(tau[v], limits->torque[v]);
    }
  }
  result->limited = true;
}
