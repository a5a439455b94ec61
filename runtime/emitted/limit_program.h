#pragma once
// Coordinates of limited_torque.h in which the cost is a sum of squares: M = L L^T,
// held rows and tasks triangular.

#include "enter_rows.h"
#include "force_basis.h"
#include "torque_limits.h"

/// The program of least distance at one state. Columns of W: rows by which passive
/// joints depend on each other, held rows, task rows, M.
struct TlLimitProgram {
  real W[TL_TABLE_ENTRIES];
  real squares[TL_COLS];  // of columns, before reflections
  real heaviest;  // of the diagonal of M
  int32_t held;  // ranks of the rows of constraints, and of the task besides
  int32_t task;
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
    for (int32_t j = first; j < TL_COLS; j += 8) {
      tl_subtract_rows(&program->W[diagonal], &program->W[j], TL_COLS, k, &row[j]);
    }
    const real inverse = TL_ONE / tl_root(row[diagonal]);
    for (int32_t j = first; j < TL_COLS; ++j) {
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

/// K K^T = 1 + k^2 R D R^T of the task's rows, K in the lower triangle.
TL_INLINE void tl_weigh_rows(
    const TlLimitProgram* program, const real* weights, real* K) {
  real scales[TL_TASK_ENTRIES];
  for (int32_t t = 0; t < TL_TASK_ENTRIES; ++t) {
    const real square = program->squares[TL_TASK_AT + t];
    scales[t] = (square > TL_ZERO)
        ? (weights[t] * TL_HIERARCHY * TL_HIERARCHY / square)
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
TL_INLINE void tl_weigh_task(TlLimitProgram* program, const real* weights) {
  real K[TL_TASK_ENTRIES * TL_TASK_ENTRIES];
  tl_weigh_rows(program, weights, &K[0]);
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
TL_INLINE void tl_reduce(TlLimitProgram* program, const real* weights) {
  for (int32_t j = 0; j < TL_COLS; ++j) {
    program->squares[j] = TL_ZERO;
  }
  for (int32_t k = 0; k < TL_VELOCITIES; ++k) {
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
    if (tl_reflect_rows(&program->W[0], TL_VELOCITIES, TL_COLS, at, j, least)) {
      if (j < TL_TASK_AT) {
        ++program->held;
      } else {
        ++program->task;
      }
    }
  }
  tl_weigh_task(program, weights);
}

/// M d_qdd at a velocity, by unknowns. Freedoms beyond those of ordinary states are
/// left alone.
TL_INLINE void tl_read_column(
    const TlLimitProgram* program, int32_t velocity, real* column) {
  const int32_t most = TL_VELOCITIES - program->held;
  const int32_t moving = (most < TL_FREEDOMS) ? most : TL_FREEDOMS;
  for (int32_t n = 0; n < TL_UNKNOWNS; ++n) {
    column[n] = TL_ZERO;
  }
  for (int32_t n = 0; n < moving; ++n) {
    column[n] = program->W[((program->held + n) * TL_COLS) + TL_MASS_AT + velocity];
  }
}

/// d_f by unknowns: those that balance a motion, then those that carry nothing, then
/// the slack.
TL_INLINE void tl_form_forces(
    const TlSupportLayout* layout, TlLimitProgram* program) {
  const TlForceBasis* const basis = &program->basis;
  const int32_t moving = TL_VELOCITIES - program->held;
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
    for (int32_t k = 0; k < (TL_HELD_ROWS - basis->rank); ++k) {
      if ((moving + k) < TL_FREEDOMS) {
        row[moving + k] = size * basis->unbound[(h * TL_HELD_ENTRIES) + k];
      }
    }
  }
}

/// Coordinates of all changes that keep the equations.
TL_INLINE void tl_set_up(const TlSupportLayout* layout, TlLimitProgram* program,
    const TlTorqueLimits* limits, const real* M, const real* J_s, const real* J_t) {
  tl_find_force_basis(layout, J_s, &program->basis);
  tl_factor_mass(program, M);
  tl_whiten(program, J_s, J_t);
  tl_relate_passive(layout, program);
  tl_reduce(program, &limits->task_weights[0]);
  tl_form_forces(layout, program);
}
