// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_SQUARE_ROOT_HPP
#define TREELINE_UR10E_SQUARE_ROOT_HPP
// Square root, because no library is at hand: the target's instruction where there is
// one, and not the builtin, which without -fno-math-errno may call the library for
// negative numbers. Elsewhere, or where TREELINE_PORTABLE_SQUARE_ROOT is defined, it
// is found bit by bit. Both round correctly, so every target gives the same bits.
// Generated; see ur10e.hpp for the contract.


#include "sin_cos.hpp"

namespace ur10e {
namespace detail {

#if defined(TREELINE_PORTABLE_SQUARE_ROOT) || !defined(__GNUC__)
#elif defined(__SSE2_MATH__) && defined(__AVX__)
#define TREELINE_UR10E_ROOT_OF_FLOAT(root, x) __asm__("vsqrtss %1, %1, %0" : "=x"(root) : "x"(x))
#define TREELINE_UR10E_ROOT_OF_DOUBLE(root, x) __asm__("vsqrtsd %1, %1, %0" : "=x"(root) : "x"(x))
#elif defined(__SSE2_MATH__)
#define TREELINE_UR10E_ROOT_OF_FLOAT(root, x) __asm__("sqrtss %1, %0" : "=x"(root) : "x"(x))
#define TREELINE_UR10E_ROOT_OF_DOUBLE(root, x) __asm__("sqrtsd %1, %0" : "=x"(root) : "x"(x))
#elif defined(__aarch64__)
#define TREELINE_UR10E_ROOT_OF_FLOAT(root, x) __asm__("fsqrt %s0, %s1" : "=w"(root) : "w"(x))
#define TREELINE_UR10E_ROOT_OF_DOUBLE(root, x) __asm__("fsqrt %d0, %d1" : "=w"(root) : "w"(x))
#elif defined(__ARM_FP)
#if (__ARM_FP & 4) != 0
#define TREELINE_UR10E_ROOT_OF_FLOAT(root, x) __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(x))
#endif
#if (__ARM_FP & 8) != 0
#define TREELINE_UR10E_ROOT_OF_DOUBLE(root, x) __asm__("vsqrt.f64 %P0, %P1" : "=w"(root) : "w"(x))
#endif
#elif defined(__riscv_fsqrt) && defined(__riscv_flen)
#if __riscv_flen >= 32
#define TREELINE_UR10E_ROOT_OF_FLOAT(root, x) __asm__("fsqrt.s %0, %1" : "=f"(root) : "f"(x))
#endif
#if __riscv_flen >= 64
#define TREELINE_UR10E_ROOT_OF_DOUBLE(root, x) __asm__("fsqrt.d %0, %1" : "=f"(root) : "f"(x))
#endif
#endif

/// All ones or zeros.
inline uint64_t mask_of(bool condition) {
  const uint64_t zero = 0;
  const uint64_t one = 1;
  return zero - (condition ? one : zero);
}

/// The bits of the root of a normal positive number, by the digit recurrence of Sun's
/// fdlibm: one bit of the root a turn, without branch. What is left decides the last
/// rounding; it is never a tie.
inline uint64_t root_of_normal(uint64_t bits) {
  const uint64_t zero = 0;
  const uint64_t one = 1;
  const uint64_t bias = 1023;
  const uint64_t exponent = bits >> 52U;
  const uint64_t even = ~exponent & one;  // of an odd power of two: the bias is odd
  const uint64_t leading = one << 52U;
  uint64_t left = ((bits & (leading - one)) | leading) << (even + one);
  uint64_t root = 0;
  uint64_t twice = 0;
  for (uint64_t bit = leading << 1; bit != zero; bit >>= 1) {
    const uint64_t tried = twice + bit;
    const uint64_t fits = mask_of(tried <= left);
    twice += fits & (bit << 1);
    left -= fits & tried;
    root += fits & bit;
    left <<= 1;
  }
  root += root & one;
  return (root >> 1) + ((((exponent + bias) >> 1) - one) << 52U);
}

/// The square root without an instruction for it.
inline double portable_square_root(double x) {
  const uint64_t zero = 0;
  const uint64_t one = 1;
  const uint64_t bias = 1023;
  const uint64_t sign = one << 63U;
  const uint64_t infinity = (bias + bias + one) << 52U;
  const uint64_t none = infinity | (one << (52U - 1U));
  const uint64_t least_normal = one << 52U;
  uint64_t given;
  to_bits(&x, &given);
  // Subnormal numbers are made normal, by an even power of two.
  const uint64_t subnormal = mask_of((given << 1) < (least_normal << 1));
  const uint64_t power = ((52U + 2U) / 2U) * 2U;
  const uint64_t raised = power << 52U;
  const uint64_t factor_bits = (bias << 52U) + (subnormal & raised);
  double factor;
  from_bits(&factor_bits, &factor);
  const double scaled = x * factor;
  uint64_t normal;
  to_bits(&scaled, &normal);
  const uint64_t root = root_of_normal(normal) - (subnormal & (raised >> 1));
  // Zeros, infinity and NaN are their own roots; negative numbers have none.
  const uint64_t own =
      mask_of((given << 1) == zero) | mask_of((given & ~sign) >= infinity);
  const uint64_t negative =
      mask_of(given > sign) & mask_of(given <= (sign | infinity));
  const uint64_t result_bits =
      (negative & none) | (~negative & ((own & given) | (~own & root)));
  double result;
  from_bits(&result_bits, &result);
  return result;
}

/// Square root of x, correctly rounded; NaN for x < 0, -0 for -0.
inline double square_root(double x) {
#if defined(TREELINE_UR10E_ROOT_OF_DOUBLE)
  double root;
  TREELINE_UR10E_ROOT_OF_DOUBLE(root, x);
  return root;
#else
  return portable_square_root(x);
#endif
}

/// Square root of x, correctly rounded; 0 for what rounding has made negative.
inline double root(double x) {
  return square_root((x > 0.0) ? x : 0.0);
}

}  // namespace detail
}  // namespace ur10e

#endif  // TREELINE_UR10E_SQUARE_ROOT_HPP
