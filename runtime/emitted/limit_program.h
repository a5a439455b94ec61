#pragma once
// Coordinates of limited_torque.h in which the cost is a sum of squares: M = L L^T,
// held rows and tasks triangular.

#include "enter_rows.h"
#include "force_basis.h"
#include "torque_limits.h"

/// The program of least distance at one state. Columns of W: rows by which passive
/// joints depend on each other, held rows, task rows, M, and of shares those forces
/// that carry nothing, which then have rows behind those of velocities.
struct TlLimitProgram {
  real W[TL_TABLE_ENTRIES];
  int32_t used_rows;  // of W
  int32_t used_cols;
  real squares[TL_COLS];  // of columns, before reflections
  real heaviest;  // of the diagonal of M
  int32_t held;  // ranks of the rows of constraints, and of the task besides
  int32_t task;
  real weights[TL_TASK_ENTRIES];  // of task rows; 0 of those that are not done
  TlForceBasis basis;
  real forces[TL_FORCE_ENTRIES];  // d_f by unknowns
  real slack;  // N, per unit of the last unknown
  TlRowsOfLimits rows;
  TlActiveSet set;
};
typedef struct TlLimitProgram TlLimitProgram;

/// L of M = L L^T, transposed, as the last columns of W.
TL_INLINE void tl_factor_mass(TlLimitProgram* program, const real* M) {
  program->heaviest = TL_ZERO;
  for (int32_t k = 0; k < TL_VELOCITIES; ++k) {
    real* const row = &program->W[k * TL_COLS];
    const int32_t diagonal = TL_MASS_AT + k;
    const int32_t first = (diagonal / 8) * 8;
    const real own = M[(k * TL_VELOCITIES) + k];
    program->heaviest = (program->heaviest < own) ? own : program->heaviest;
    for (int32_t j = 0; j < TL_COLS; ++j) {
      row[j] = TL_ZERO;
    }
    for (int32_t j = k; j < TL_VELOCITIES; ++j) {
      row[TL_MASS_AT + j] = M[(k * TL_VELOCITIES) + j];
    }
    for (int32_t j = first; j < TL_MASS_END; j += 8) {
      tl_subtract_rows(&program->W[diagonal], &program->W[j], TL_COLS, k, &row[j]);
    }
    const real inverse = TL_ONE / tl_root(row[diagonal]);
    for (int32_t j = first; j < TL_MASS_END; ++j) {
      row[j] = (j < diagonal) ? TL_ZERO : (row[j] * inverse);
    }
  }
}

/// L^-1 J^T of held rows and tasks.
TL_INLINE void tl_whiten(TlLimitProgram* program, const real* J_s, const real* J_t) {
  for (int32_t k = 0; k < TL_VELOCITIES; ++k) {
    real* const own = &program->W[k * TL_COLS];
    real row[TL_COLS];
    for (int32_t j = 0; j < TL_COLS; ++j) {
      row[j] = TL_ZERO;
    }
    for (int32_t h = 0; h < TL_HELD_ROWS; ++h) {
      row[TL_PASSIVE_ENTRIES + h] = J_s[(h * TL_VELOCITIES) + k];
    }
    for (int32_t t = 0; t < TL_TASK_ROWS; ++t) {
      row[TL_TASK_AT + t] = J_t[(t * TL_VELOCITIES) + k];
    }
    for (int32_t j = (TL_PASSIVE_ENTRIES / 8) * 8; j < TL_MASS_AT; j += 8) {
      tl_subtract_rows(
          &program->W[TL_MASS_AT + k], &program->W[j], TL_COLS, k, &row[j]);
    }
    const real inverse = TL_ONE / own[TL_MASS_AT + k];
    for (int32_t j = TL_PASSIVE_ENTRIES; j < TL_MASS_AT; ++j) {
      own[j] = row[j] * inverse;
    }
  }
}

/// Passive entries of M d_qdd that no force of a support balances vanish.
TL_INLINE void tl_relate_passive(
    const TlSupportLayout* layout, TlLimitProgram* program) {
  const TlForceBasis* const basis = &program->basis;
  for (int32_t k = 0; k < TL_VELOCITIES; ++k) {
    real* const row = &program->W[k * TL_COLS];
    const real* const mass = &row[TL_MASS_AT];
    for (int32_t j = 0; j < TL_PASSIVE_ENTRIES; ++j) {
      real entry = TL_ZERO;
      if (basis->depends[j]) {
        entry = mass[layout->passive[j]];
        for (int32_t r = 0; r < basis->rank; ++r) {
          entry -= basis->relations[(j * TL_PASSIVE_ENTRIES) + r] *
              mass[layout->passive[basis->carried[r]]];
        }
      }
      row[j] = entry;
    }
  }
}

#if TL_SHARES
/// The equation of a row that is held to the share w, w J d_qdd + (1 - w) Lambda^-1
/// d_f = 0, Lambda^-1 its own entry, in motions and in forces that carry nothing. Of
/// a row that is not held none is left.
TL_INLINE void tl_yield_row(
    TlLimitProgram* program, const TlSupportLayout* layout, int32_t h) {
  const TlForceBasis* const basis = &program->basis;
  const real share = layout->shares[h];
  const real size = TL_HIERARCHY * tl_root(program->heaviest);
  real mobility = TL_ZERO;
  for (int32_t k = 0; k < TL_VELOCITIES; ++k) {
    const real along = program->W[(k * TL_COLS) + TL_PASSIVE_ENTRIES + h];
    mobility += along * along;
  }
  const real yields = (TL_ONE - share) * mobility;
  for (int32_t k = 0; k < TL_VELOCITIES; ++k) {
    real* const row = &program->W[k * TL_COLS];
    real force = TL_ZERO;
    for (int32_t r = 0; r < basis->rank; ++r) {
      force += basis->carry[(h * TL_PASSIVE_ENTRIES) + r] *
          row[TL_MASS_AT + layout->passive[basis->carried[r]]];
    }
    row[TL_PASSIVE_ENTRIES + h] =
        (share * row[TL_PASSIVE_ENTRIES + h]) + (yields * force);
  }
  for (int32_t k = TL_VELOCITIES; k < program->used_rows; ++k) {
    program->W[(k * TL_COLS) + TL_PASSIVE_ENTRIES + h] =
        yields * size * basis->unbound[(h * TL_HELD_ENTRIES) + k - TL_VELOCITIES];
  }
}

/// Where rows are held in part, forces that carry nothing move them: they become
/// entries beside those of velocities.
TL_INLINE void tl_yield(const TlSupportLayout* layout, TlLimitProgram* program) {
  const TlForceBasis* const basis = &program->basis;
  bool whole = true;
  for (int32_t i = 0; i < basis->present; ++i) {
    whole = whole && (layout->shares[basis->order[i]] >= TL_ONE);
  }
  if (!whole) {
    program->used_rows = TL_VELOCITIES + basis->present - basis->rank;
    program->used_cols = TL_COLS;
  }
  for (int32_t k = TL_VELOCITIES; k < program->used_rows; ++k) {
    real* const row = &program->W[k * TL_COLS];
    for (int32_t j = 0; j < TL_COLS; ++j) {
      row[j] = TL_ZERO;
    }
    row[TL_FORCES_AT + k - TL_VELOCITIES] = TL_ONE;
  }
  for (int32_t h = 0; h < TL_HELD_ROWS; ++h) {
    if (!(layout->shares[h] >= TL_ONE)) {
      tl_yield_row(program, layout, h);
    }
  }
}

#endif
/// K K^T = 1 + k^2 R D R^T of the task's rows, K in the lower triangle.
TL_INLINE void tl_weigh_rows(const TlLimitProgram* program, real* K) {
  real scales[TL_TASK_ENTRIES];
  for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
    const real square = program->squares[TL_TASK_AT + t];
    scales[t] = (square > TL_ZERO)
        ? (program->weights[t] * TL_HIERARCHY * TL_HIERARCHY / square)
        : TL_ZERO;
  }
  for (int32_t i = 0; i < program->task; ++i) {
    const real* const row = &program->W[(program->held + i) * TL_COLS];
    for (int32_t j = 0; j <= i; ++j) {
      const real* const other = &program->W[(program->held + j) * TL_COLS];
      real entry = (i == j) ? TL_ONE : TL_ZERO;
      for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
        entry += row[TL_TASK_AT + t] * scales[t] * other[TL_TASK_AT + t];
      }
      K[(i * TL_TASK_ENTRIES) + j] = entry;
    }
  }
  for (int32_t j = 0; j < program->task; ++j) {
    K[(j * TL_TASK_ENTRIES) + j] = tl_root(K[(j * TL_TASK_ENTRIES) + j]);
    for (int32_t i = j + 1; i < program->task; ++i) {
      K[(i * TL_TASK_ENTRIES) + j] /= K[(j * TL_TASK_ENTRIES) + j];
    }
    for (int32_t i = j + 1; i < program->task; ++i) {
      for (int32_t k = j + 1; k <= i; ++k) {
        K[(i * TL_TASK_ENTRIES) + k] -=
            K[(i * TL_TASK_ENTRIES) + j] * K[(k * TL_TASK_ENTRIES) + j];
      }
    }
  }
}

/// Unknowns of the task such that their squares are its cost: its rows become K^-1
/// times what they are.
TL_INLINE void tl_weigh_task(TlLimitProgram* program) {
  real K[TL_TASK_ENTRIES * TL_TASK_ENTRIES];
  tl_weigh_rows(program, &K[0]);
  for (int32_t i = 0; i < program->task; ++i) {
    real* const place = &program->W[((program->held + i) * TL_COLS) + TL_TASK_AT];
    real row[TL_TASK_COLS];
    for (int32_t j = 0; j < TL_TASK_COLS; ++j) {
      row[j] = place[j];
    }
    for (int32_t m = 0; m < i; ++m) {
      const real* const before =
          &program->W[((program->held + m) * TL_COLS) + TL_TASK_AT];
      const real factor = K[(i * TL_TASK_ENTRIES) + m];
      for (int32_t j = 0; j < TL_TASK_COLS; ++j) {
        row[j] -= factor * before[j];
      }
    }
    const real inverse = TL_ONE / K[(i * TL_TASK_ENTRIES) + i];
    for (int32_t j = 0; j < TL_TASK_COLS; ++j) {
      place[j] = row[j] * inverse;
    }
  }
}

/// Reflects so that equations concern the first entries only, tasks the next.
TL_INLINE void tl_reduce(TlLimitProgram* program) {
  for (int32_t j = 0; j < TL_COLS; ++j) {
    program->squares[j] = TL_ZERO;
  }
  for (int32_t k = 0; k < program->used_rows; ++k) {
    const real* const row = &program->W[k * TL_COLS];
    for (int32_t j = 0; j < TL_MASS_AT; ++j) {
      program->squares[j] += row[j] * row[j];
    }
  }
  program->held = 0;
  program->task = 0;
  for (int32_t j = 0; j < TL_MASS_AT; ++j) {
    const int32_t at = program->held + program->task;
    const real least = TL_RANK_TOLERANCE * tl_root(program->squares[j]);
    const bool counts =
        (j < TL_TASK_AT) || (program->weights[j - TL_TASK_AT] > TL_ZERO);
    if (counts &&
        tl_reflect_rows(&program->W[0], program->used_rows, TL_COLS,
            program->used_cols, at, j, least)) {
      if (j < TL_TASK_AT) {
        ++program->held;
      } else {
        ++program->task;
      }
    }
  }
  tl_weigh_task(program);
}

/// M d_qdd at a velocity, by unknowns. Freedoms beyond those of ordinary states are
/// left alone.
TL_INLINE void tl_read_column(
    const TlLimitProgram* program, int32_t velocity, real* column) {
  const int32_t most = program->used_rows - program->held;
  const int32_t moving = (most < TL_FREEDOMS) ? most : TL_FREEDOMS;
  for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
    column[n] = TL_ZERO;
  }
  for (int32_t n = 0; n < moving; ++n) {
    column[n] = program->W[((program->held + n) * TL_COLS) + TL_MASS_AT + velocity];
  }
}

/// `force` times what carries nothing number k, by unknowns.
TL_INLINE void tl_add_unbound(
    const TlLimitProgram* program, int32_t k, real force, real* row) {
  const int32_t moving = program->used_rows - program->held;
  if (program->used_rows > TL_VELOCITIES) {
    for (int32_t n = 0; (n < moving) && (n < TL_FREEDOMS); ++n) {
      row[n] +=
          force * program->W[((program->held + n) * TL_COLS) + TL_FORCES_AT + k];
    }
  } else if ((moving + k) < TL_FREEDOMS) {
    row[moving + k] = force;
  } else {
    // It is none of the freedoms in ordinary states.
  }
}

/// d_f by unknowns: those that balance a motion, then those that carry nothing, then
/// the slack.
TL_INLINE void tl_form_forces(
    const TlSupportLayout* layout, TlLimitProgram* program) {
  const TlForceBasis* const basis = &program->basis;
  const real size = TL_HIERARCHY * tl_root(program->heaviest);
  real carried[TL_CARRIED_ENTRIES];
  for (int32_t r = 0; r < basis->rank; ++r) {
    tl_read_column(
        program, layout->passive[basis->carried[r]], &carried[r * TL_UNKNOWNS]);
  }
  for (int32_t h = 0; h < TL_HELD_ENTRIES; ++h) {
    real* const row = &program->forces[h * TL_UNKNOWNS];
    for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
      row[n] = TL_ZERO;
    }
    for (int32_t r = 0; r < basis->rank; ++r) {
      const real factor = basis->carry[(h * TL_PASSIVE_ENTRIES) + r];
      for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
        row[n] += factor * carried[(r * TL_UNKNOWNS) + n];
      }
    }
    for (int32_t k = 0; k < (basis->present - basis->rank); ++k) {
      const real force = size * basis->unbound[(h * TL_HELD_ENTRIES) + k];
      tl_add_unbound(program, k, force, row);
    }
  }
}

/// Coordinates of all changes that keep the equations.
TL_INLINE void tl_set_up(const TlSupportLayout* layout, TlLimitProgram* program,
    const TlTorqueLimits* limits, const real* M, const real* J_s, const real* J_t) {
  program->used_rows = TL_VELOCITIES;
  program->used_cols = TL_MASS_END;
  for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
    program->weights[t] = limits->task_weights[t];
    if (TL_SHARES) {
      program->weights[t] *= layout->task_weights[t];
    }
  }
  tl_find_force_basis(layout, J_s, &program->basis);
  tl_factor_mass(program, M);
  tl_whiten(program, J_s, J_t);
  tl_relate_passive(layout, program);
  if (TL_SHARES) {
    tl_yield(layout, program);
  }
  tl_reduce(program);
  tl_form_forces(layout, program);
}
