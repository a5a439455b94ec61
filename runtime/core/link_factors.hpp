#pragma once
// A = L D L^T of symmetric matrices of any size, whose pivots may yield. C++17, freestanding.

namespace treeline::core::loops {

/// 1 / c where it is large; smooth, bounded and 0 where it falls to 0: c^(power - 1) / (c^power +
/// border^power). `yield` is the border to that power. Of power 8, which rows in the order of
/// priority have, it is 1 / border. Without a power 1 / c.
template <int power, class Real>
Real bounded_inverse(const Real& c, const Real& yield) noexcept {
  static_assert((power == 0) || (power == 4) || (power == 6) || (power == 8),
                "a law for rows that yield");
  Real dividend = Real(1.0);
  Real divisor = c;
  if constexpr (power != 0) {
    const Real c2 = c * c;
    const Real c3 = c2 * c;
    if constexpr (power == 4) {
      dividend = c3;
      divisor = (c2 * c2) + yield;
    } else if constexpr (power == 8) {
      const Real t = c * yield;
      const Real t2 = t * t;
      const Real t4 = t2 * t2;
      dividend = yield * ((t4 * t2) * t);
      divisor = Real(1.0) + (t4 * t4);
    } else {
      dividend = c3 * c2;
      divisor = (c3 * c3) + yield;
    }
  }
  return dividend / divisor;
}

/// Factors the row-major n x n matrix A in place, of which the lower triangle is read: L below the
/// diagonal, what stands for 1 / D on it. `yields` are those of the pivots.
template <int power, class Real>
void factor(Real* A, int n, const Real* yields) noexcept {
  for (int k = 0; k < n; ++k) {
    Real& pivot = A[(k * n) + k];
    pivot = bounded_inverse<power>(pivot, (power == 0) ? pivot : yields[k]);
    for (int i = n - 1; i > k; --i) {  // from below, so that the rows above are still A's
      const Real l = A[(i * n) + k] * pivot;
      int j = k + 1;
      do {
        A[(i * n) + j] = A[(i * n) + j] - (l * A[(j * n) + k]);
        ++j;
      } while (j <= i);
      A[(i * n) + k] = l;
    }
  }
}

/// Makes x L^-1 x.
template <class Real>
void solve_lower(const Real* factors, int n, Real* x) noexcept {
  for (int i = 0; i < n; ++i) {
    Real left = x[i];
    for (int k = 0; k < i; ++k) {
      left = left - (factors[(i * n) + k] * x[k]);
    }
    x[i] = left;
  }
}

/// Makes x A^-1 x.
template <class Real>
void solve(const Real* factors, int n, Real* x) noexcept {
  solve_lower(factors, n, x);
  for (int i = n - 1; i >= 0; --i) {
    Real left = x[i] * factors[(i * n) + i];
    for (int k = i + 1; k < n; ++k) {
      left = left - (factors[(k * n) + i] * x[k]);
    }
    x[i] = left;
  }
}

/// Makes L below the diagonal of `factors` L^-1, of which the diagonal is 1.
template <class Real>
void invert_lower(Real* factors, int n) noexcept {
  for (int j = 0; j < n; ++j) {
    for (int i = j + 1; i < n; ++i) {
      Real sum = factors[(i * n) + j];
      for (int k = j + 1; k < i; ++k) {
        sum = sum + (factors[(i * n) + k] * factors[(k * n) + j]);
      }
      factors[(i * n) + j] = -sum;
    }
  }
}

/// A^-1 = L^-T D^-1 L^-1 by factors whose L is inverted.
template <class Real>
void multiply_inverses(const Real* factors, int n, Real* inverse) noexcept {
  for (int k = 0; k < n; ++k) {
    const Real* const row = &factors[k * n];
    const Real pivot = row[k];
    for (int s = 0; s < k; ++s) {
      inverse[(k * n) + s] = pivot * row[s];
    }
    inverse[(k * n) + k] = pivot;
    for (int r = 0; r < k; ++r) {
      const Real scaled = row[r] * pivot;
      int s = 0;
      do {
        inverse[(r * n) + s] = inverse[(r * n) + s] + (scaled * row[s]);
        ++s;
      } while (s <= r);
    }
  }
  for (int r = 0; r < n; ++r) {
    for (int s = 0; s < r; ++s) {
      inverse[(s * n) + r] = inverse[(r * n) + s];
    }
  }
}

}  // namespace treeline::core::loops
