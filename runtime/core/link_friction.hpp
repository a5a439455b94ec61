#pragma once
// The smooth sign of Coulomb friction. C++17, freestanding.
//
// tanh(n artanh(x / n)) with n = 128: odd, slope 1 at 0, never beyond 1, within 1.3e-5 of tanh(x)
// up to |x| = 2600, above 0.995 up to n^2 / 3 = 5461; beyond, it falls off like n^2 / x. It takes
// products, sums and quotients only: with t = tanh a, tanh 2a once and tanh 4a three times.

namespace treeline::core::loops {

/// tanh 2a = 2t / (1 + t^2)
template <class Real>
Real double_tangent(const Real& t) noexcept {
  const Real square = t * t;
  const Real divisor = Real(1.0) + square;
  return (Real(2.0) * t) / divisor;
}

/// tanh 4a = 4t (1 + t^2) / (1 + 6t^2 + t^4)
template <class Real>
Real quadruple_tangent(const Real& t) noexcept {
  const Real square = t * t;
  const Real divisor = Real(1.0) + (square * (Real(6.0) + square));
  return (Real(4.0) * t * (Real(1.0) + square)) / divisor;
}

template <class Real>
Real friction_sign(const Real& x) noexcept {
  Real sign = double_tangent<Real>(x * Real(0x1p-7));
  for (int i = 0; i < 3; ++i) {
    sign = quadruple_tangent<Real>(sign);
  }
  return sign;
}

/// The derivative of `friction_sign`.
template <class Real>
Real friction_slope(const Real& x) noexcept {
  const Real first = x * Real(0x1p-7);
  const Real first_square = first * first;
  const Real first_divisor = Real(1.0) + first_square;
  Real sign = double_tangent<Real>(first);
  Real slope = (Real(0x1p-6) * (Real(1.0) - first_square)) / (first_divisor * first_divisor);
  for (int i = 0; i < 3; ++i) {
    const Real square = sign * sign;
    const Real divisor = Real(1.0) + (square * (Real(6.0) + square));
    const Real rest = Real(1.0) - square;
    slope = slope * ((Real(4.0) * rest * rest * rest) / (divisor * divisor));
    sign = quadruple_tangent<Real>(sign);
  }
  return slope;
}

}  // namespace treeline::core::loops
