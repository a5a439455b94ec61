#pragma once
// Limits of motors and supports, and what became of them.

#include "limit_sizes.h"

/// A row of a cone: coefficients of up to six forces of a support, from `first` on,
/// whose sum is at most `bound`.
struct TlConeRow {
  int32_t first;
  int32_t count;
  real coefficients[6];
  real bound;
};
typedef struct TlConeRow TlConeRow;

/// What may be asked of motors and supports.
struct TlTorqueLimits {
  real torque[TL_VELOCITIES];  // largest magnitude; 1e30: none
  TlConeRow cones[TL_CONE_ENTRIES];
  real task_weights[TL_TASK_ENTRIES];  // of task rows against each other
};
typedef struct TlTorqueLimits TlTorqueLimits;

/// What became of the limits. Begin with zeros and pass the same one in every cycle:
/// each starts from the active limits of the last.
struct TlLimitedTorque {
  bool limited;  // whether anything had to be changed
  int32_t status;  // TL_SOLVED or another of those above; see there
  int32_t iterations;  // of the quadratic program
  real slack;  // N by which cones were widened; 0 where forces are within them
  real lost[TL_TASK_ENTRIES];  // xdd of the task by the unlimited law, less what is
                               // left
  bool warm;  // whether `sides` are those of a cycle before
  int32_t sides[TL_UNKNOWNS + TL_LIMIT_ROWS];  // of unknowns, motors, cones
};
typedef struct TlLimitedTorque TlLimitedTorque;
