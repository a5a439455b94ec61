#pragma once
// A = L D L^T of symmetric matrices of any size, whose pivots may yield.

/// 1 / c where it is large; smooth, bounded and 0 where it falls to 0: c^(power - 1)
/// / (c^power + border^power). `yield` is the border to that power. Of power 8, which
/// rows in the order of priority have, it is 1 / border. Without a power 1 / c.
TL_INLINE real tl_bounded_inverse(int32_t power, real c, real yield) {
  real dividend = TL_ONE;
  real divisor = c;
  if (power != 0) {
    const real c2 = c * c;
    const real c3 = c2 * c;
    if (power == 4) {
      dividend = c3;
      divisor = (c2 * c2) + yield;
    } else if (power == 8) {
      const real t = c * yield;
      const real t2 = t * t;
      const real t4 = t2 * t2;
      dividend = yield * ((t4 * t2) * t);
      divisor = TL_ONE + (t4 * t4);
    } else {
      dividend = c3 * c2;
      divisor = (c3 * c3) + yield;
    }
  }
  return dividend / divisor;
}

/// Factors the row-major n x n matrix A in place, of which the lower triangle is
/// read: L below the diagonal, what stands for 1 / D on it. `yields` are those of the
/// pivots.
TL_INLINE void tl_factor(int32_t power, real* A, int32_t n, const real* yields) {
  for (int32_t k = 0; k < n; ++k) {
    real* const pivot = &A[(k * n) + k];
    *pivot = tl_bounded_inverse(power, *pivot, (power == 0) ? (*pivot) : yields[k]);
    // From below, so that the rows above are still A's.
    for (int32_t i = n - 1; i > k; --i) {
      const real l = A[(i * n) + k] * (*pivot);
      int32_t j = k + 1;
      do {
        A[(i * n) + j] = A[(i * n) + j] - (l * A[(j * n) + k]);
        ++j;
      } while (j <= i);
      A[(i * n) + k] = l;
    }
  }
}

/// Makes x L^-1 x.
TL_INLINE void tl_solve_lower(const real* factors, int32_t n, real* x) {
  for (int32_t i = 0; i < n; ++i) {
    real left = x[i];
    for (int32_t k = 0; k < i; ++k) {
      left = left - (factors[(i * n) + k] * x[k]);
    }
    x[i] = left;
  }
}

/// Makes x A^-1 x.
TL_INLINE void tl_solve(const real* factors, int32_t n, real* x) {
  tl_solve_lower(factors, n, x);
  for (int32_t i = n - 1; i >= 0; --i) {
    real left = x[i] * factors[(i * n) + i];
    for (int32_t k = i + 1; k < n; ++k) {
      left = left - (factors[(k * n) + i] * x[k]);
    }
    x[i] = left;
  }
}

/// Makes L below the diagonal of `factors` L^-1, of which the diagonal is 1.
TL_INLINE void tl_invert_lower(real* factors, int32_t n) {
  for (int32_t j = 0; j < n; ++j) {
    for (int32_t i = j + 1; i < n; ++i) {
      real sum = factors[(i * n) + j];
      for (int32_t k = j + 1; k < i; ++k) {
        sum = sum + (factors[(i * n) + k] * factors[(k * n) + j]);
      }
      factors[(i * n) + j] = -sum;
    }
  }
}

/// A^-1 = L^-T D^-1 L^-1 by factors whose L is inverted.
TL_INLINE void tl_multiply_inverses(const real* factors, int32_t n, real* inverse) {
  for (int32_t k = 0; k < n; ++k) {
    const real* const row = &factors[k * n];
    const real pivot = row[k];
    for (int32_t s = 0; s < k; ++s) {
      inverse[(k * n) + s] = pivot * row[s];
    }
    inverse[(k * n) + k] = pivot;
    for (int32_t r = 0; r < k; ++r) {
      const real scaled = row[r] * pivot;
      int32_t s = 0;
      do {
        inverse[(r * n) + s] = inverse[(r * n) + s] + (scaled * row[s]);
        ++s;
      } while (s <= r);
    }
  }
  for (int32_t r = 0; r < n; ++r) {
    for (int32_t s = 0; s < r; ++s) {
      inverse[(s * n) + r] = inverse[(r * n) + s];
    }
  }
}
