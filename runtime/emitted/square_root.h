#pragma once
// Square root, because no library is at hand: the target's instruction where there is
// one, and not the builtin, which without -fno-math-errno may call the library for
// negative numbers. Elsewhere, or where TREELINE_PORTABLE_SQUARE_ROOT is defined, it
// is found bit by bit. Both round correctly, so every target gives the same bits.

#include <stdbool.h>

#include "sin_cos.h"

#if defined(TREELINE_PORTABLE_SQUARE_ROOT) || !defined(__GNUC__)
#elif defined(__SSE2_MATH__) && defined(__AVX__)
#define TL_ROOT_OF_FLOAT(root, x) __asm__("vsqrtss %1, %1, %0" : "=x"(root) : "x"(x))
#define TL_ROOT_OF_DOUBLE(root, x) __asm__("vsqrtsd %1, %1, %0" : "=x"(root) : "x"(x))
#elif defined(__SSE2_MATH__)
#define TL_ROOT_OF_FLOAT(root, x) __asm__("sqrtss %1, %0" : "=x"(root) : "x"(x))
#define TL_ROOT_OF_DOUBLE(root, x) __asm__("sqrtsd %1, %0" : "=x"(root) : "x"(x))
#elif defined(__aarch64__)
#define TL_ROOT_OF_FLOAT(root, x) __asm__("fsqrt %s0, %s1" : "=w"(root) : "w"(x))
#define TL_ROOT_OF_DOUBLE(root, x) __asm__("fsqrt %d0, %d1" : "=w"(root) : "w"(x))
#elif defined(__ARM_FP)
#if (__ARM_FP & 4) != 0
#define TL_ROOT_OF_FLOAT(root, x) __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(x))
#endif
#if (__ARM_FP & 8) != 0
#define TL_ROOT_OF_DOUBLE(root, x) __asm__("vsqrt.f64 %P0, %P1" : "=w"(root) : "w"(x))
#endif
#elif defined(__riscv_fsqrt) && defined(__riscv_flen)
#if __riscv_flen >= 32
#define TL_ROOT_OF_FLOAT(root, x) __asm__("fsqrt.s %0, %1" : "=f"(root) : "f"(x))
#endif
#if __riscv_flen >= 64
#define TL_ROOT_OF_DOUBLE(root, x) __asm__("fsqrt.d %0, %1" : "=f"(root) : "f"(x))
#endif
#endif

/// All ones or zeros.
TL_INLINE TlBits tl_mask_of(bool condition) {
  const TlBits zero = 0;
  const TlBits one = 1;
  return zero - (condition ? one : zero);
}

/// The bits of the root of a normal positive number, by the digit recurrence of Sun's
/// fdlibm: one bit of the root a turn, without branch. What is left decides the last
/// rounding; it is never a tie.
TL_INLINE TlBits tl_root_of_normal(TlBits bits) {
  const TlBits zero = 0;
  const TlBits one = 1;
  const TlBits bias = TL_BIAS;
  const TlBits exponent = bits >> TL_FRACTION_BITS;
  const TlBits even = ~exponent & one;  // of an odd power of two: the bias is odd
  const TlBits leading = one << TL_FRACTION_BITS;
  TlBits left = ((bits & (leading - one)) | leading) << (even + one);
  TlBits root = 0;
  TlBits twice = 0;
  for (TlBits bit = leading << 1; bit != zero; bit >>= 1) {
    const TlBits tried = twice + bit;
    const TlBits fits = tl_mask_of(tried <= left);
    twice += fits & (bit << 1);
    left -= fits & tried;
    root += fits & bit;
    left <<= 1;
  }
  root += root & one;
  return (root >> 1) + ((((exponent + bias) >> 1) - one) << TL_FRACTION_BITS);
}

/// The square root without an instruction for it.
TL_INLINE real tl_portable_square_root(real x) {
  const TlBits zero = 0;
  const TlBits one = 1;
  const TlBits bias = TL_BIAS;
  const TlBits sign = one << TL_SIGN_AT;
  const TlBits infinity = (bias + bias + one) << TL_FRACTION_BITS;
  const TlBits none = infinity | (one << (TL_FRACTION_BITS - 1U));
  const TlBits least_normal = one << TL_FRACTION_BITS;
  TlBits given;
  tl_to_bits(&x, &given);
  // Subnormal numbers are made normal, by an even power of two.
  const TlBits subnormal = tl_mask_of((given << 1) < (least_normal << 1));
  const TlBits power = ((TL_FRACTION_BITS + 2U) / 2U) * 2U;
  const TlBits raised = power << TL_FRACTION_BITS;
  const TlBits factor_bits = (bias << TL_FRACTION_BITS) + (subnormal & raised);
  real factor;
  tl_from_bits(&factor_bits, &factor);
  const real scaled = x * factor;
  TlBits normal;
  tl_to_bits(&scaled, &normal);
  const TlBits root = tl_root_of_normal(normal) - (subnormal & (raised >> 1));
  // Zeros, infinity and NaN are their own roots; negative numbers have none.
  const TlBits own =
      tl_mask_of((given << 1) == zero) | tl_mask_of((given & ~sign) >= infinity);
  const TlBits negative =
      tl_mask_of(given > sign) & tl_mask_of(given <= (sign | infinity));
  const TlBits result_bits =
      (negative & none) | (~negative & ((own & given) | (~own & root)));
  real result;
  tl_from_bits(&result_bits, &result);
  return result;
}

/// Square root of x, correctly rounded; NaN for x < 0, -0 for -0.
TL_INLINE real tl_square_root(real x) {
#if defined(TL_ROOT_INSTRUCTION)
  real root;
  TL_ROOT_INSTRUCTION(root, x);
  return root;
#else
  return tl_portable_square_root(x);
#endif
}

/// Square root of x, correctly rounded; 0 for what rounding has made negative.
TL_INLINE real tl_root(real x) {
  return tl_square_root((x > TL_ZERO) ? x : TL_ZERO);
}
