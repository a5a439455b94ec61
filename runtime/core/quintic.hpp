#pragma once
// Quintic motion of a vector from any state to rest. C++17, freestanding, fixed size.

#include <stddef.h>

namespace treeline::core {

/// Coefficients of the motion of N numbers that leaves `x0` with velocity `v0` and acceleration
/// `a0` and is at rest in `x1` after `duration` > 0 seconds, as a polynomial in the share u of the
/// time that is left: x = x1 + u^3 (c1 + u (c2 + u c3)). So the end is x1 to the bit, with velocity
/// and acceleration zero. Row-major, a row of N for each of x1, c1, c2, c3.
template <size_t N, class Real>
inline void quintic_to_rest(const Real (&x0)[N], const Real (&v0)[N], const Real (&a0)[N],
                            const Real (&x1)[N], Real duration, Real* coefficients) noexcept {
  for (size_t i = 0; i < N; ++i) {
    const Real away = x0[i] - x1[i];
    const Real slope = -v0[i] * duration;
    const Real bend = a0[i] * duration * duration;
    coefficients[i] = x1[i];
    coefficients[N + i] = (Real(10) * away) - (Real(4) * slope) + (Real(0.5) * bend);
    coefficients[(2 * N) + i] = (Real(-15) * away) + (Real(7) * slope) - bend;
    coefficients[(3 * N) + i] = (Real(6) * away) - (Real(3) * slope) + (Real(0.5) * bend);
  }
}

/// The share of a motion's time that is left `time` seconds after its begin, 0 behind its end;
/// `rate` is 1 / duration.
template <class Real>
constexpr Real share_left(Real time, Real rate) noexcept {
  const Real left = Real(1) - (time * rate);
  return (left > Real(0)) ? ((left < Real(1)) ? left : Real(1)) : Real(0);
}

/// State of a motion of `quintic_to_rest` where the share `left` of its time is left.
template <size_t N, class Real>
inline void quintic_at(const Real* coefficients, Real left, Real rate, Real (&x)[N], Real (&v)[N],
                       Real (&a)[N]) noexcept {
  const Real* const c1 = coefficients + N;
  const Real* const c2 = coefficients + (2 * N);
  const Real* const c3 = coefficients + (3 * N);
  const Real square = left * left;
  for (size_t i = 0; i < N; ++i) {
    x[i] = coefficients[i] + (square * left * (c1[i] + (left * (c2[i] + (left * c3[i])))));
    v[i] = -rate * square *
           ((Real(3) * c1[i]) + (left * ((Real(4) * c2[i]) + (left * (Real(5) * c3[i])))));
    a[i] = rate * rate * left *
           ((Real(6) * c1[i]) + (left * ((Real(12) * c2[i]) + (left * (Real(20) * c3[i])))));
  }
}

/// 1 where all of the time is left, 0 where none is, with first and second derivative zero at both
/// ends.
template <class Real>
constexpr Real fade_out(Real left) noexcept {
  return left * left * left * (Real(10) + (left * (Real(-15) + (left * Real(6)))));
}

}  // namespace treeline::core
