#pragma once
// Sums and tolerances of quadratic_program.hpp.

#include "core/load_lanes.hpp"
#include "core/sin_cos.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::steps {

template <class Real>
constexpr Real size_of(Real x) noexcept {
  return x < Real(0) ? -x : x;
}
template <class Real>
constexpr Real larger_of(Real a, Real b) noexcept {
  return a < b ? b : a;
}
/// False for NaN and infinities.
template <class Real>
constexpr bool is_finite(Real x) noexcept {
  return x - x == Real(0);
}

/// Sum of products, in eight sums that run side by side.
template <int N, class Real>
inline Real dot_of(const Real* a, const Real* b) noexcept {
  constexpr int kInEights = N / 8 * 8;
  auto sums = Lanes<Real, 8>::spread(Real(0));
  Lanes<Real, 8> x, y;
  for (int i = 0; i < kInEights; i += 8) {
    load_lanes(a + i, x);
    load_lanes(b + i, y);
    add_lanes(x * y, sums);
  }
  Real s[8];
  store_lanes(sums, s);
  for (int i = kInEights; i < N; ++i) s[i - kInEights] += a[i] * b[i];
  return ((s[0] + s[4]) + (s[1] + s[5])) + ((s[2] + s[6]) + (s[3] + s[7]));
}

/// The same of their sizes.
template <int N, class Real>
inline Real dot_of_sizes(const Real* a, const Real* b) noexcept {
  Real sums[8];
  for (Real& each : sums) each = Real(0);
  int i = 0;
  for (; i + 8 <= N; i += 8) {
    for (int k = 0; k < 8; ++k) sums[k] += size_of(a[i + k] * b[i + k]);
  }
  for (int k = 0; i + k < N; ++k) sums[k] += size_of(a[i + k] * b[i + k]);
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

/// x + sum of factors[k] times row k of `rows`, k from `first` to before `last`.
template <int N, class Real>
inline void add_rows(const Real* factors, const Real* rows, int first, int last,
                     Real (&x)[N]) noexcept {
  Real sum[N];
  for (int i = 0; i < N; ++i) sum[i] = x[i];
  for (int k = first; k < last; ++k) {
    const Real factor = factors[k];
    for (int i = 0; i < N; ++i) sum[i] += factor * rows[k * N + i];
  }
  for (int i = 0; i < N; ++i) x[i] = sum[i];
}

/// Of numbers that are compared: a row holds within so many units of rounding of its terms.
template <class Real>
inline constexpr Real kRowTolerance = Real(512) * Format<Real>::kEpsilon;
/// A row depends on others where so little of its normal is left.
template <class Real>
inline constexpr Real kDependent = Real(256) * Format<Real>::kEpsilon;
/// A row that depends on others contradicts them where it misses by so much of its terms.
template <class Real>
inline constexpr Real kContradiction = Real(1 << 15) * Format<Real>::kEpsilon;

}  // namespace treeline::core::steps

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
