#pragma once
// Angular motion of a frame whose rotation vector moves. C++17, freestanding.

#include "core/orientation.hpp"

namespace treeline::core {

namespace steps {

template <class Real>
constexpr Real dot(const Real (&a)[3], const Real (&b)[3]) noexcept {
  return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

/// sum_k (-x)^k / (2k + first)! and its derivative by x. The series of sine and cosine, whose terms
/// left out are below a rounding of the sum for x <= 12, an angle of 3.4 rad.
template <class Real>
constexpr void alternating_series(Real x, int first, Real& sum, Real& slope) noexcept {
  constexpr int kTerms = (sizeof(Real) < sizeof(double)) ? 9 : 15;
  Real last = Real(1);
  for (int k = 2; k <= first; ++k) {
    last /= static_cast<Real>(k);
  }
  Real s = Real(1);
  Real d = Real(0);
  for (int k = kTerms; k > 0; --k) {
    const Real ratio = Real(1) / static_cast<Real>(((2 * k) + first - 1) * ((2 * k) + first));
    d = -ratio * (s + (x * d));
    s = Real(1) - (ratio * x * s);
  }
  sum = last * s;
  slope = last * d;
}

}  // namespace steps

/// Angular velocity `w` and acceleration `wd` of the rotation exp([r]x), in the axes in which `r`
/// is, where r moves with `rd` and `rdd`:
///   w = rd + B r x rd + C r x (r x rd),  B = (1 - cos t) / t^2,  C = (t - sin t) / t^3,  t = |r|,
/// and its derivative. Along one axis w = rd. For |r| up to 3.4 rad.
template <class Real>
inline void turn_rates(const Real (&r)[3], const Real (&rd)[3], const Real (&rdd)[3], Real (&w)[3],
                       Real (&wd)[3]) noexcept {
  Real B = Real(0);
  Real C = Real(0);
  Real dB = Real(0);
  Real dC = Real(0);
  steps::alternating_series(steps::squared_norm(r), 2, B, dB);
  steps::alternating_series(steps::squared_norm(r), 3, C, dC);
  const Real twice = Real(2) * steps::dot(r, rd);
  Real across[3];
  Real twice_across[3];
  Real turned[3];
  Real twice_turned[3];
  Real mixed[3];
  steps::cross(r, rd, across);
  steps::cross(r, across, twice_across);
  steps::cross(r, rdd, turned);
  steps::cross(r, turned, twice_turned);
  steps::cross(rd, across, mixed);
  for (int i = 0; i < 3; ++i) {
    w[i] = rd[i] + (B * across[i]) + (C * twice_across[i]);
    wd[i] = rdd[i] + (B * turned[i]) + (C * (twice_turned[i] + mixed[i])) +
            (twice * ((dB * across[i]) + (dC * twice_across[i])));
  }
}

/// A B of row-major rotation matrices.
template <class Real>
constexpr void turn_by(const Real (&A)[9], const Real (&B)[9], Real (&product)[9]) noexcept {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      product[(3 * i) + j] =
          (A[3 * i] * B[j]) + (A[(3 * i) + 1] * B[3 + j]) + (A[(3 * i) + 2] * B[6 + j]);
    }
  }
}

}  // namespace treeline::core
