// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_SYMMETRIC_EIGEN_HPP
#define TREELINE_UR10E_SYMMETRIC_EIGEN_HPP
// Eigenvalues of small symmetric matrices, and how their eigenvectors turn vectors:
// Householder's reflections to three diagonals, then sweeps of QL with Wilkinson's
// shift. A fixed number of sweeps without a branch: same time for every matrix.
// Golub, Van Loan: Matrix Computations, 4th ed., sections 8.3.1 and 8.3.5.
// Generated; see ur10e_damped.hpp for the contract.

#include "damped_sizes.hpp"
#include "square_root.hpp"

namespace ur10e {
namespace detail {

/// How eigenvectors turn vectors: reflections, then rotations of neighbouring
/// entries. To turn a vector takes fewer operations than to write the eigenvectors
/// out.
struct Turns {
  /// Column k below the diagonal: v of I - scales[k] v v^T.
  double reflections[kTaskRows * kTaskRows];
  double scales[kTaskRows];
  /// c and s in the order of the sweeps.
  double rotations[kRotations];
};

inline double absolute(double x) {
  return (x < 0.0) ? -x : x;
}

/// Divides A by its largest entry, which is returned.
inline double scale_to_one(double* A) {
  double largest = 1e-280;
  for (int32_t i = 0; i < kTaskRows; ++i) {
    for (int32_t j = 0; j <= i; ++j) {
      const double size = absolute(A[(i * kTaskRows) + j]);
      largest = (size > largest) ? size : largest;
    }
  }
  const double factor = 1.0 / largest;
  for (int32_t i = 0; i < kTaskRows; ++i) {
    for (int32_t j = 0; j <= i; ++j) {
      A[(i * kTaskRows) + j] = factor * A[(i * kTaskRows) + j];
    }
  }
  return largest;
}

/// Turns column k of A below the diagonal onto its first entry by I - scale v v^T,
/// with v in entries k + 1 and on, where it replaces the column. Returns that entry;
/// scale is 0 where nothing is to be turned.
inline double reflect_column(int32_t k, double* A, double* scale) {
  double square = 0.0;
  for (int32_t i = k + 2; i < kTaskRows; ++i) {
    square += A[(i * kTaskRows) + k] * A[(i * kTaskRows) + k];
  }
  const double first = A[((k + 1) * kTaskRows) + k];
  const double length = square_root((first * first) + square);
  const bool turns = square > 1e-280;
  const double away = (first < 0.0) ? -length : length;
  const double divisor = turns ? (length * (length + absolute(first))) : 1.0;
  const double inverse = 1.0 / divisor;
  A[((k + 1) * kTaskRows) + k] = first + away;
  *scale = turns ? inverse : 0.0;
  return turns ? -away : first;
}

/// A <- H A H in the lower triangle of rows from k + 1, with H = I - scale v v^T and
/// v in column k.
inline void apply_reflection(int32_t k, double scale, double* A) {
  double w[kTaskRows];
  for (int32_t i = k + 1; i < kTaskRows; ++i) {
    w[i] = 0.0;
    for (int32_t j = k + 1; j < i; ++j) {
      w[i] += A[(i * kTaskRows) + j] * A[(j * kTaskRows) + k];
      w[j] += A[(i * kTaskRows) + j] * A[(i * kTaskRows) + k];
    }
    w[i] += A[(i * kTaskRows) + i] * A[(i * kTaskRows) + k];
  }
  double along = 0.0;
  for (int32_t i = k + 1; i < kTaskRows; ++i) {
    w[i] = scale * w[i];
    along += w[i] * A[(i * kTaskRows) + k];
  }
  const double part = 0.5 * scale * along;
  for (int32_t i = k + 1; i < kTaskRows; ++i) {
    w[i] -= part * A[(i * kTaskRows) + k];
    for (int32_t j = k + 1; j <= i; ++j) {
      A[(i * kTaskRows) + j] -=
          (A[(i * kTaskRows) + k] * w[j]) + (w[i] * A[(j * kTaskRows) + k]);
    }
  }
}

/// x <- H x with the reflection k that tridiagonalise left in A.
inline void reflect(int32_t k, const double* A, double scale, double* x) {
  double sum = 0.0;
  for (int32_t i = k + 1; i < kTaskRows; ++i) {
    sum += A[(i * kTaskRows) + k] * x[i];
  }
  sum = scale * sum;
  for (int32_t i = k + 1; i < kTaskRows; ++i) {
    x[i] -= sum * A[(i * kTaskRows) + k];
  }
}

/// T = H A H^T with the diagonal d and e[i] between d[i] and d[i + 1], where H is the
/// product of the reflections, the last first. Reads the lower triangle of A and
/// leaves the reflections in its columns.
inline void tridiagonalise(double* A, double* scales, double* d, double* e) {
  for (int32_t k = 0; k < (kTaskRows - 2); ++k) {
    e[k] = reflect_column(k, A, &scales[k]);
    apply_reflection(k, scales[k], A);
  }
  for (int32_t k = 0; k < kTaskRows; ++k) {
    d[k] = A[(k * kTaskRows) + k];
  }
  for (int32_t k = kTaskRows - 2; (k >= 0) && (k > (kTaskRows - 3)); --k) {
    e[k] = A[((k + 1) * kTaskRows) + k];
  }
}

/// The eigenvalue of the first block that has not come apart: that of its upper left
/// 2 x 2 which is nearer to the upper left entry.
inline double shift_of(const double* d, const double* e) {
  int32_t top = 0;
  for (int32_t i = kTaskRows - 2; i >= 0; --i) {
    top = (absolute(e[i]) > 0x1p-50) ? i : top;
  }
  const double beside = e[top];
  const double part = 0.5 * (d[top + 1] - d[top]);
  const double length = square_root((part * part) + (beside * beside));
  const double away = (part < 0.0) ? -length : length;
  const double sum = part + away;
  return d[top] - (beside * (beside / ((length > 0.0) ? sum : 1.0)));
}

/// One sweep of implicit QL over all blocks. Where an e is negligible it becomes 0,
/// the rotation nothing, and the next block begins. Writes the rotations of entries i
/// and i + 1, the last first.
inline void sweep_up(double* d, double* e, double* rotations) {
  const double shift = shift_of(d, e);
  double c = 1.0;
  double s = 1.0;
  double change = 0.0;  // what d[i + 1] still has to lose
  double left = 0.0;  // what e[i + 1] is if its block ends above it
  double g = d[kTaskRows - 1] - shift;
  bool begins = true;  // a block at d[i + 1]
  int32_t at = 0;
  for (int32_t i = kTaskRows - 2; i >= 0; --i) {
    const bool splits = !(absolute(e[i]) > 0x1p-50);
    const double held = splits ? 0.0 : e[i];
    const double f = s * held;
    const double b = c * held;
    const double square = (f * f) + (g * g);
    const bool turns = (!splits) && (square > 1e-280);
    const double length = square_root(square);
    const double factor = 1.0 / (turns ? length : 1.0);
    c = (turns ? g : 1.0) * factor;
    s = f * factor;
    e[i + 1] = (splits || begins) ? left : length;
    const double kept = d[i + 1] - change;
    const double r = ((d[i] - kept) * s) + (2.0 * c * b);
    change = s * r;
    d[i + 1] = kept + change;
    left = (c * r) - b;
    const double anew = d[i] - shift;
    g = splits ? anew : left;
    rotations[at] = c;
    rotations[at + 1] = s;
    at += 2;
    s = splits ? 1.0 : s;
    begins = splits;
  }
  d[0] -= change;
  e[0] = left;
}

/// The eigenvalues, in no order, of the matrix whose lower triangle is in
/// turns->reflections.
inline void diagonalise(Turns* turns, double* values) {
  double beside[kTaskRows];
  const double largest = scale_to_one(&turns->reflections[0]);
  tridiagonalise(&turns->reflections[0], &turns->scales[0], values, &beside[0]);
  for (int32_t sweep = 0; sweep < kSweeps; ++sweep) {
    const int32_t first = sweep * 2 * (kTaskRows - 1);
    sweep_up(values, &beside[0], &turns->rotations[first]);
  }
  for (int32_t i = 0; i < kTaskRows; ++i) {
    values[i] = largest * values[i];
  }
}

/// Turns x into the axes of the eigenvectors.
inline void turn(const Turns* turns, double* x) {
  for (int32_t k = 0; k < (kTaskRows - 2); ++k) {
    reflect(k, &turns->reflections[0], turns->scales[k], x);
  }
  int32_t at = 0;
  for (int32_t sweep = 0; sweep < kSweeps; ++sweep) {
    double last = x[kTaskRows - 1];
    for (int32_t i = kTaskRows - 2; i >= 0; --i) {
      const double c = turns->rotations[at];
      const double s = turns->rotations[at + 1];
      at += 2;
      x[i + 1] = (s * x[i]) + (c * last);
      last = (c * x[i]) - (s * last);
    }
    x[0] = last;
  }
}

/// Turns x back from the axes of the eigenvectors.
inline void turn_back(const Turns* turns, double* x) {
  int32_t at = 2 * (kTaskRows - 1) * kSweeps;
  for (int32_t sweep = 0; sweep < kSweeps; ++sweep) {
    double front = x[0];
    for (int32_t i = 0; i < (kTaskRows - 1); ++i) {
      at -= 2;
      const double c = turns->rotations[at];
      const double s = turns->rotations[at + 1];
      x[i] = (c * front) + (s * x[i + 1]);
      front = (c * x[i + 1]) - (s * front);
    }
    x[kTaskRows - 1] = front;
  }
  for (int32_t k = kTaskRows - 3; k >= 0; --k) {
    reflect(k, &turns->reflections[0], turns->scales[k], x);
  }
}

}  // namespace detail
}  // namespace ur10e

#endif  // TREELINE_UR10E_SYMMETRIC_EIGEN_HPP
