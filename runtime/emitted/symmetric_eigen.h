#pragma once
// Eigenvalues of small symmetric matrices, and how their eigenvectors turn vectors:
// Householder's reflections to three diagonals, then sweeps of QL with Wilkinson's
// shift. A fixed number of sweeps without a branch: same time for every matrix.
// Golub, Van Loan: Matrix Computations, 4th ed., sections 8.3.1 and 8.3.5.

#include "damped_sizes.h"
#include "square_root.h"

/// How eigenvectors turn vectors: reflections, then rotations of neighbouring
/// entries. To turn a vector takes fewer operations than to write the eigenvectors
/// out.
struct TlTurns {
  /// Column k below the diagonal: v of I - scales[k] v v^T.
  real reflections[TL_TASK_ROWS * TL_TASK_ROWS];
  real scales[TL_TASK_ROWS];
  /// c and s in the order of the sweeps.
  real rotations[TL_ROTATIONS];
};
typedef struct TlTurns TlTurns;

TL_INLINE real tl_absolute(real x) {
  return (x < TL_ZERO) ? -x : x;
}

/// Divides A by its largest entry, which is returned.
TL_INLINE real tl_scale_to_one(real* A) {
  real largest = TL_LOST_SQUARE;
  for (int32_t i = 0; i < TL_TASK_ROWS; ++i) {
    for (int32_t j = 0; j <= i; ++j) {
      const real size = tl_absolute(A[(i * TL_TASK_ROWS) + j]);
      largest = (size > largest) ? size : largest;
    }
  }
  const real factor = TL_ONE / largest;
  for (int32_t i = 0; i < TL_TASK_ROWS; ++i) {
    for (int32_t j = 0; j <= i; ++j) {
      A[(i * TL_TASK_ROWS) + j] = factor * A[(i * TL_TASK_ROWS) + j];
    }
  }
  return largest;
}

/// Turns column k of A below the diagonal onto its first entry by I - scale v v^T,
/// with v in entries k + 1 and on, where it replaces the column. Returns that entry;
/// scale is 0 where nothing is to be turned.
TL_INLINE real tl_reflect_column(int32_t k, real* A, real* scale) {
  real square = TL_ZERO;
  for (int32_t i = k + 2; i < TL_TASK_ROWS; ++i) {
    square += A[(i * TL_TASK_ROWS) + k] * A[(i * TL_TASK_ROWS) + k];
  }
  const real first = A[((k + 1) * TL_TASK_ROWS) + k];
  const real length = tl_square_root((first * first) + square);
  const bool turns = square > TL_LOST_SQUARE;
  const real away = (first < TL_ZERO) ? -length : length;
  const real divisor = turns ? (length * (length + tl_absolute(first))) : TL_ONE;
  const real inverse = TL_ONE / divisor;
  A[((k + 1) * TL_TASK_ROWS) + k] = first + away;
  *scale = turns ? inverse : TL_ZERO;
  return turns ? -away : first;
}

/// A <- H A H in the lower triangle of rows from k + 1, with H = I - scale v v^T and
/// v in column k.
TL_INLINE void tl_apply_reflection(int32_t k, real scale, real* A) {
  real w[TL_TASK_ROWS];
  for (int32_t i = k + 1; i < TL_TASK_ROWS; ++i) {
    w[i] = TL_ZERO;
    for (int32_t j = k + 1; j < i; ++j) {
      w[i] += A[(i * TL_TASK_ROWS) + j] * A[(j * TL_TASK_ROWS) + k];
      w[j] += A[(i * TL_TASK_ROWS) + j] * A[(i * TL_TASK_ROWS) + k];
    }
    w[i] += A[(i * TL_TASK_ROWS) + i] * A[(i * TL_TASK_ROWS) + k];
  }
  real along = TL_ZERO;
  for (int32_t i = k + 1; i < TL_TASK_ROWS; ++i) {
    w[i] = scale * w[i];
    along += w[i] * A[(i * TL_TASK_ROWS) + k];
  }
  const real part = TL_HALF * scale * along;
  for (int32_t i = k + 1; i < TL_TASK_ROWS; ++i) {
    w[i] -= part * A[(i * TL_TASK_ROWS) + k];
    for (int32_t j = k + 1; j <= i; ++j) {
      A[(i * TL_TASK_ROWS) + j] -=
          (A[(i * TL_TASK_ROWS) + k] * w[j]) + (w[i] * A[(j * TL_TASK_ROWS) + k]);
    }
  }
}

/// x <- H x with the reflection k that tl_tridiagonalise left in A.
TL_INLINE void tl_reflect(int32_t k, const real* A, real scale, real* x) {
  real sum = TL_ZERO;
  for (int32_t i = k + 1; i < TL_TASK_ROWS; ++i) {
    sum += A[(i * TL_TASK_ROWS) + k] * x[i];
  }
  sum = scale * sum;
  for (int32_t i = k + 1; i < TL_TASK_ROWS; ++i) {
    x[i] -= sum * A[(i * TL_TASK_ROWS) + k];
  }
}

/// T = H A H^T with the diagonal d and e[i] between d[i] and d[i + 1], where H is the
/// product of the reflections, the last first. Reads the lower triangle of A and
/// leaves the reflections in its columns.
TL_INLINE void tl_tridiagonalise(real* A, real* scales, real* d, real* e) {
  for (int32_t k = 0; k < (TL_TASK_ROWS - 2); ++k) {
    e[k] = tl_reflect_column(k, A, &scales[k]);
    tl_apply_reflection(k, scales[k], A);
  }
  for (int32_t k = 0; k < TL_TASK_ROWS; ++k) {
    d[k] = A[(k * TL_TASK_ROWS) + k];
  }
  for (int32_t k = TL_TASK_ROWS - 2; (k >= 0) && (k > (TL_TASK_ROWS - 3)); --k) {
    e[k] = A[((k + 1) * TL_TASK_ROWS) + k];
  }
}

/// The eigenvalue of the first block that has not come apart: that of its upper left
/// 2 x 2 which is nearer to the upper left entry.
TL_INLINE real tl_shift_of(const real* d, const real* e) {
  int32_t top = 0;
  for (int32_t i = TL_TASK_ROWS - 2; i >= 0; --i) {
    top = (tl_absolute(e[i]) > TL_NEGLIGIBLE) ? i : top;
  }
  const real beside = e[top];
  const real part = TL_HALF * (d[top + 1] - d[top]);
  const real length = tl_square_root((part * part) + (beside * beside));
  const real away = (part < TL_ZERO) ? -length : length;
  const real sum = part + away;
  return d[top] - (beside * (beside / ((length > TL_ZERO) ? sum : TL_ONE)));
}

/// One sweep of implicit QL over all blocks. Where an e is negligible it becomes 0,
/// the rotation nothing, and the next block begins. Writes the rotations of entries i
/// and i + 1, the last first.
TL_INLINE void tl_sweep_up(real* d, real* e, real* rotations) {
  const real shift = tl_shift_of(d, e);
  real c = TL_ONE;
  real s = TL_ONE;
  real change = TL_ZERO;  // what d[i + 1] still has to lose
  real left = TL_ZERO;  // what e[i + 1] is if its block ends above it
  real g = d[TL_TASK_ROWS - 1] - shift;
  bool begins = true;  // a block at d[i + 1]
  int32_t at = 0;
  for (int32_t i = TL_TASK_ROWS - 2; i >= 0; --i) {
    const bool splits = !(tl_absolute(e[i]) > TL_NEGLIGIBLE);
    const real held = splits ? TL_ZERO : e[i];
    const real f = s * held;
    const real b = c * held;
    const real square = (f * f) + (g * g);
    const bool turns = (!splits) && (square > TL_LOST_SQUARE);
    const real length = tl_square_root(square);
    const real factor = TL_ONE / (turns ? length : TL_ONE);
    c = (turns ? g : TL_ONE) * factor;
    s = f * factor;
    e[i + 1] = (splits || begins) ? left : length;
    const real kept = d[i + 1] - change;
    const real r = ((d[i] - kept) * s) + (TL_TWO * c * b);
    change = s * r;
    d[i + 1] = kept + change;
    left = (c * r) - b;
    const real anew = d[i] - shift;
    g = splits ? anew : left;
    rotations[at] = c;
    rotations[at + 1] = s;
    at += 2;
    s = splits ? TL_ONE : s;
    begins = splits;
  }
  d[0] -= change;
  e[0] = left;
}

/// The eigenvalues, in no order, of the matrix whose lower triangle is in
/// turns->reflections.
TL_INLINE void tl_diagonalise(TlTurns* turns, real* values) {
  real beside[TL_TASK_ROWS];
  const real largest = tl_scale_to_one(&turns->reflections[0]);
  tl_tridiagonalise(&turns->reflections[0], &turns->scales[0], values, &beside[0]);
  for (int32_t sweep = 0; sweep < TL_SWEEPS; ++sweep) {
    const int32_t first = sweep * 2 * (TL_TASK_ROWS - 1);
    tl_sweep_up(values, &beside[0], &turns->rotations[first]);
  }
  for (int32_t i = 0; i < TL_TASK_ROWS; ++i) {
    values[i] = largest * values[i];
  }
}

/// Turns x into the axes of the eigenvectors.
TL_INLINE void tl_turn(const TlTurns* turns, real* x) {
  for (int32_t k = 0; k < (TL_TASK_ROWS - 2); ++k) {
    tl_reflect(k, &turns->reflections[0], turns->scales[k], x);
  }
  int32_t at = 0;
  for (int32_t sweep = 0; sweep < TL_SWEEPS; ++sweep) {
    real last = x[TL_TASK_ROWS - 1];
    for (int32_t i = TL_TASK_ROWS - 2; i >= 0; --i) {
      const real c = turns->rotations[at];
      const real s = turns->rotations[at + 1];
      at += 2;
      x[i + 1] = (s * x[i]) + (c * last);
      last = (c * x[i]) - (s * last);
    }
    x[0] = last;
  }
}

/// Turns x back from the axes of the eigenvectors.
TL_INLINE void tl_turn_back(const TlTurns* turns, real* x) {
  int32_t at = 2 * (TL_TASK_ROWS - 1) * TL_SWEEPS;
  for (int32_t sweep = 0; sweep < TL_SWEEPS; ++sweep) {
    real front = x[0];
    for (int32_t i = 0; i < (TL_TASK_ROWS - 1); ++i) {
      at -= 2;
      const real c = turns->rotations[at];
      const real s = turns->rotations[at + 1];
      x[i] = (c * front) + (s * x[i + 1]);
      front = (c * x[i + 1]) - (s * front);
    }
    x[TL_TASK_ROWS - 1] = front;
  }
  for (int32_t k = TL_TASK_ROWS - 3; k >= 0; --k) {
    tl_reflect(k, &turns->reflections[0], turns->scales[k], x);
  }
}
