#pragma once
// The square root of runtime/emitted for float and double. C++17, freestanding.

#include <stdbool.h>
#include <stdint.h>

#include "core/sin_cos.hpp"

namespace treeline::core {

#define TL_INLINE static inline

/// Everything of runtime/emitted/square_root.h, but for instructions of the target.
template <class Number>
struct EmittedSquareRoot {
  using real = Number;
  using TlBits = typename Format<real>::Bits;
  static constexpr real TL_ZERO = 0;
  static constexpr uint32_t TL_FRACTION_BITS = Format<real>::kFractionBits,
                            TL_SIGN_AT = Format<real>::kSignAt;
  static constexpr TlBits TL_BIAS = Format<real>::kOne >> TL_FRACTION_BITS;

  static void tl_to_bits(const real* x, TlBits* bits) noexcept { to_bits(x, bits); }
  static void tl_from_bits(const TlBits* bits, real* x) noexcept { from_bits(bits, x); }

#include "emitted/square_root.h"
};

#undef TL_INLINE

/// Square root of `x`, correctly rounded; NaN for x < 0, -0 for -0.
inline float square_root(float x) noexcept {
#if defined(TL_ROOT_OF_FLOAT)
  float root;
  TL_ROOT_OF_FLOAT(root, x);
  return root;
#else
  return EmittedSquareRoot<float>::tl_portable_square_root(x);
#endif
}
inline double square_root(double x) noexcept {
#if defined(TL_ROOT_OF_DOUBLE)
  double root;
  TL_ROOT_OF_DOUBLE(root, x);
  return root;
#else
  return EmittedSquareRoot<double>::tl_portable_square_root(x);
#endif
}

#undef TL_ROOT_OF_FLOAT
#undef TL_ROOT_OF_DOUBLE

}  // namespace treeline::core
