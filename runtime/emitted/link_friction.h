#pragma once
// The smooth sign of Coulomb friction.
//
// tanh(n artanh(x / n)) with n = 128: odd, slope 1 at 0, never beyond 1,
// within 1.3e-5 of tanh(x) up to |x| = 2600, above 0.995 up to n^2 / 3 = 5461;
// beyond, it falls off like n^2 / x. It takes products, sums and quotients only: with
// t = tanh a, tanh 2a once and tanh 4a three times.

/// tanh 2a = 2t / (1 + t^2)
TL_INLINE real tl_double_tangent(real t) {
  const real square = t * t;
  const real divisor = TL_ONE + square;
  return (TL_REAL(2.0) * t) / divisor;
}

/// tanh 4a = 4t (1 + t^2) / (1 + 6t^2 + t^4)
TL_INLINE real tl_quadruple_tangent(real t) {
  const real square = t * t;
  const real divisor = TL_ONE + (square * (TL_REAL(6.0) + square));
  return (TL_REAL(4.0) * t * (TL_ONE + square)) / divisor;
}

TL_INLINE real tl_friction_sign(real x) {
  real sign = tl_double_tangent(x * TL_REAL(0x1p-7));
  for (int32_t i = 0; i < 3; ++i) {
    sign = tl_quadruple_tangent(sign);
  }
  return sign;
}

/// The derivative of `tl_friction_sign`.
TL_INLINE real tl_friction_slope(real x) {
  const real first = x * TL_REAL(0x1p-7);
  const real first_square = first * first;
  const real first_divisor = TL_ONE + first_square;
  real sign = tl_double_tangent(first);
  real slope =
      (TL_REAL(0x1p-6) * (TL_ONE - first_square)) / (first_divisor * first_divisor);
  for (int32_t i = 0; i < 3; ++i) {
    const real square = sign * sign;
    const real divisor = TL_ONE + (square * (TL_REAL(6.0) + square));
    const real rest = TL_ONE - square;
    slope = slope * ((TL_REAL(4.0) * rest * rest * rest) / (divisor * divisor));
    sign = tl_quadruple_tangent(sign);
  }
  return slope;
}
