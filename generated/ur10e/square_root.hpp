#ifndef TREELINE_UR10E_SQUARE_ROOT_HPP
#define TREELINE_UR10E_SQUARE_ROOT_HPP
// Square root, because no library is at hand. C++17, freestanding.
//
// Where the target has an instruction for it that is what is executed, and not the builtin: without
// -fno-math-errno compilers let that call the library for negative numbers. Elsewhere, or where
// TREELINE_PORTABLE_SQUARE_ROOT is defined, it is found bit by bit. Both round correctly, so every
// target gives the same bits.

#include <stdint.h>

#include "sin_cos.hpp"

#if defined(TREELINE_PORTABLE_SQUARE_ROOT) || !defined(__GNUC__)
#elif defined(__SSE2_MATH__) && defined(__AVX__)
#define TREELINE_ROOT_OF_FLOAT(root, x) __asm__("vsqrtss %1, %1, %0" : "=x"(root) : "x"(x))
#define TREELINE_ROOT_OF_DOUBLE(root, x) __asm__("vsqrtsd %1, %1, %0" : "=x"(root) : "x"(x))
#elif defined(__SSE2_MATH__)
#define TREELINE_ROOT_OF_FLOAT(root, x) __asm__("sqrtss %1, %0" : "=x"(root) : "x"(x))
#define TREELINE_ROOT_OF_DOUBLE(root, x) __asm__("sqrtsd %1, %0" : "=x"(root) : "x"(x))
#elif defined(__aarch64__)
#define TREELINE_ROOT_OF_FLOAT(root, x) __asm__("fsqrt %s0, %s1" : "=w"(root) : "w"(x))
#define TREELINE_ROOT_OF_DOUBLE(root, x) __asm__("fsqrt %d0, %d1" : "=w"(root) : "w"(x))
#elif defined(__ARM_FP)
#if (__ARM_FP & 4) != 0
#define TREELINE_ROOT_OF_FLOAT(root, x) __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(x))
#endif
#if (__ARM_FP & 8) != 0
#define TREELINE_ROOT_OF_DOUBLE(root, x) __asm__("vsqrt.f64 %P0, %P1" : "=w"(root) : "w"(x))
#endif
#elif defined(__riscv_fsqrt) && defined(__riscv_flen)
#if __riscv_flen >= 32
#define TREELINE_ROOT_OF_FLOAT(root, x) __asm__("fsqrt.s %0, %1" : "=f"(root) : "f"(x))
#endif
#if __riscv_flen >= 64
#define TREELINE_ROOT_OF_DOUBLE(root, x) __asm__("fsqrt.d %0, %1" : "=f"(root) : "f"(x))
#endif
#endif

namespace ur10e::detail {

namespace steps {

/// A number of all ones or zeros.
template <class Bits>
constexpr Bits mask_of(bool condition) noexcept {
  return Bits{0} - static_cast<Bits>(condition);
}

/// The bits of the root of a normal positive number, by the digit recurrence of Sun's fdlibm: one
/// bit of the root a turn, without branch. What is left decides the last rounding; it is never a
/// tie.
template <class Real>
constexpr typename Format<Real>::Bits root_of_normal(typename Format<Real>::Bits bits) noexcept {
  using F = Format<Real>;
  using Bits = typename F::Bits;
  const Bits exponent = bits >> F::kFractionBits;
  const Bits even = ~exponent & Bits{1};  // of an odd power of two: the bias is odd
  Bits left = ((bits & ((Bits{1} << F::kFractionBits) - Bits{1})) | (Bits{1} << F::kFractionBits))
              << (even + Bits{1});
  Bits root = 0;
  Bits twice = 0;
  for (Bits bit = Bits{1} << (F::kFractionBits + 1); bit != 0; bit >>= 1) {
    const Bits tried = twice + bit;
    const Bits fits = mask_of<Bits>(tried <= left);
    twice += fits & (bit << 1);
    left -= fits & tried;
    root += fits & bit;
    left <<= 1;
  }
  root += root & Bits{1};
  const Bits half = (exponent + (F::kOne >> F::kFractionBits)) >> 1;
  return (root >> 1) + ((half - Bits{1}) << F::kFractionBits);
}

/// The square root without an instruction for it.
template <class Real>
inline Real portable_square_root(Real x) noexcept {
  using F = Format<Real>;
  using Bits = typename F::Bits;
  constexpr Bits kSign = Bits{1} << F::kSignAt;
  constexpr Bits kInfinity = (F::kOne << 1) + (Bits{1} << F::kFractionBits);
  Bits given = 0;
  OneLane<Real>::to_bits(x, given);
  // Subnormal numbers are made normal, by an even power of two.
  const Bits subnormal = mask_of<Bits>((given << 1) < (Bits{2} << F::kFractionBits));
  constexpr Bits kRaised = Bits{2 * ((F::kFractionBits + 2) / 2)} << F::kFractionBits;
  Real factor = 0;
  OneLane<Real>::from_bits(F::kOne + (subnormal & kRaised), factor);
  Bits normal = 0;
  OneLane<Real>::to_bits(x * factor, normal);
  const Bits root = root_of_normal<Real>(normal) - (subnormal & (kRaised >> 1));
  // Zeros, infinity and NaN are their own roots; negative numbers have none.
  const Bits own = mask_of<Bits>((given << 1) == 0) | mask_of<Bits>((given & ~kSign) >= kInfinity);
  const Bits negative = mask_of<Bits>(given > kSign) & mask_of<Bits>(given <= (kSign | kInfinity));
  constexpr Bits kNone = kInfinity | (Bits{1} << (F::kFractionBits - 1));
  Real result = 0;
  OneLane<Real>::from_bits((negative & kNone) | (~negative & ((own & given) | (~own & root))),
                           result);
  return result;
}

}  // namespace steps

/// Square root of `x`, correctly rounded; NaN for x < 0, -0 for -0.
inline float square_root(float x) noexcept {
#if defined(TREELINE_ROOT_OF_FLOAT)
  float root;
  TREELINE_ROOT_OF_FLOAT(root, x);
  return root;
#else
  return steps::portable_square_root(x);
#endif
}
inline double square_root(double x) noexcept {
#if defined(TREELINE_ROOT_OF_DOUBLE)
  double root;
  TREELINE_ROOT_OF_DOUBLE(root, x);
  return root;
#else
  return steps::portable_square_root(x);
#endif
}

#undef TREELINE_ROOT_OF_FLOAT
#undef TREELINE_ROOT_OF_DOUBLE

}  // namespace ur10e::detail

#endif  // TREELINE_UR10E_SQUARE_ROOT_HPP
