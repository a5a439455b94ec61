#pragma once
// Sine and cosine together, without branch, table, heap or library: C++17, freestanding. Every
// generated folder carries its own copy in one file, in a namespace of its own, so that robots
// generated at different times live in one program.
//
// Doubles are computed in double, floats in float: a target with a single-precision unit executes
// no double operation for them. Every operation is one IEEE operation in round-to-nearest, and the
// order of operations matters: compile without -ffast-math and its parts (-fassociative-math,
// -ffinite-math-only, ...), which would cancel the rounding trick away. -ffp-contract may be on or
// off: no step relies on a fused multiply-add and none is spoilt by one. With it off, all lanes and
// the scalar function give the same bits.

#include <stdint.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "sin_cos.hpp: compile without -ffast-math (put -fno-fast-math behind it)"
#endif

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// What is known of a number's format: the integer of its size and the constants below.
template <class Real>
struct Format;
template <>
struct Format<double> {
  using Bits = uint64_t;
  static constexpr int kFractionBits = 52;
  static constexpr int kSignAt = 63;
  static constexpr double kEpsilon = 0x1p-52;  // from 1 to the next number
  static constexpr Bits kOne = Bits{1023} << 52;
  /// 1.5 * 2^52: a double next to it is an integer, so adding it rounds to the nearest integer,
  /// whose low bits can be read off, and subtracting it gives the integer back.
  static constexpr double kRoundingShift = 6755399441055744.0;
  static constexpr double kTwoOverPi = 0.6366197723675814;
  static constexpr Bits kLargestExponent = 32;  // angles beyond 2^32 rad count as quarter turns
};
template <>
struct Format<float> {
  using Bits = uint32_t;
  static constexpr int kFractionBits = 23;
  static constexpr int kSignAt = 31;
  static constexpr float kEpsilon = 0x1p-23F;
  static constexpr Bits kOne = Bits{127} << 23;
  static constexpr float kRoundingShift = 12582912.0F;  // 1.5 * 2^23
  static constexpr float kTwoOverPi = 0x1.45f306p-1F;
  static constexpr Bits kLargestExponent = 20;
};

// Where there is one: of a copy by __builtin_memcpy some compilers make a call for doubles.
#if defined(__has_builtin)
#if __has_builtin(__builtin_bit_cast)
#define TREELINE_HAS_BIT_CAST
#endif
#endif

// g++ for RISC-V calls functions of one instruction unless it is told not to.
#if defined(__GNUC__)
#define TREELINE_INLINE_BITS inline __attribute__((always_inline))
#else
#define TREELINE_INLINE_BITS inline
#endif

/// One number with the bits it is made of.
template <class Number>
struct OneLane {
  using Real = Number;
  using Value = Real;
  using Bits = typename Format<Real>::Bits;
  static TREELINE_INLINE_BITS void to_bits(const Value& value, Bits& bits) noexcept {
    copy(value, bits);
  }
  static TREELINE_INLINE_BITS void from_bits(const Bits& bits, Value& value) noexcept {
    copy(bits, value);
  }

 private:
  template <class From, class To>
  static TREELINE_INLINE_BITS void copy(const From& from, To& to) noexcept {
    static_assert(sizeof(From) == sizeof(To));
#if defined(TREELINE_HAS_BIT_CAST)
    to = __builtin_bit_cast(To, from);
#elif defined(__GNUC__)
    __builtin_memcpy(&to, &from, sizeof(To));
#else
    const auto* source = reinterpret_cast<const unsigned char*>(&from);
    auto* target = reinterpret_cast<unsigned char*>(&to);
    for (unsigned i = 0; i < sizeof(To); ++i) {
      target[i] = source[i];
    }
#endif
  }
};

/// The bits of one number, as headers of runtime/emitted take them.
template <class Real>
TREELINE_INLINE_BITS void to_bits(const Real* value, typename Format<Real>::Bits* bits) noexcept {
  OneLane<Real>::to_bits(*value, *bits);
}

/// The number of these bits.
template <class Real>
TREELINE_INLINE_BITS void from_bits(const typename Format<Real>::Bits* bits, Real* value) noexcept {
  OneLane<Real>::from_bits(*bits, *value);
}

// Only where there are wide registers: elsewhere the extension would be unpacked again.
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && \
    !defined(TREELINE_NO_VECTOR_EXTENSIONS)
#define TREELINE_HAS_LANES
#define TREELINE_INLINE_LANES inline __attribute__((always_inline))
/// Numbers side by side. What is wider than the target's registers becomes several operations.
/// Passed by reference only: the calling convention of such a value depends on the target's flags.
template <class Number, int count>
struct VectorLanes {
  using Real = Number;
  typedef Real Value __attribute__((vector_size(count * sizeof(Real))));
  typedef typename Format<Real>::Bits Bits __attribute__((vector_size(count * sizeof(Real))));

  static TREELINE_INLINE_LANES void to_bits(const Value& value, Bits& bits) noexcept {
    bits = reinterpret_cast<Bits>(value);
  }
  static TREELINE_INLINE_LANES void from_bits(const Bits& bits, Value& value) noexcept {
    value = reinterpret_cast<Value>(bits);
  }
};

#if defined(__AVX512F__)
inline constexpr int kDoublesAtOnce = 8;
#else
inline constexpr int kDoublesAtOnce = 4;
#endif
#if defined(__AVX__)
inline constexpr int kFloatsAtOnce = 8;
#else
inline constexpr int kFloatsAtOnce = 4;
#endif
#else
#define TREELINE_INLINE_LANES inline
#endif

#define TL_INLINE static TREELINE_INLINE_LANES

/// What takes the bits of numbers, on one lane or several.
template <class Lanes>
struct QuarterTurns {
  using real = typename Lanes::Real;
  using TlBits = typename Format<real>::Bits;
  using TlAngle = typename Lanes::Value;
  using TlAngleBits = typename Lanes::Bits;
  static constexpr uint32_t TL_FRACTION_BITS = Format<real>::kFractionBits,
                            TL_SIGN_AT = Format<real>::kSignAt;
  static constexpr TlBits TL_BIAS = Format<real>::kOne >> TL_FRACTION_BITS,
                          TL_LARGEST_EXPONENT = Format<real>::kLargestExponent;
  static constexpr real TL_ROUNDING_SHIFT = Format<real>::kRoundingShift,
                        TL_TWO_OVER_PI = Format<real>::kTwoOverPi;

  TL_INLINE void tl_to_bits(const TlAngle* x, TlAngleBits* bits) { Lanes::to_bits(*x, *bits); }
  TL_INLINE void tl_from_bits(const TlAngleBits* bits, TlAngle* x) { Lanes::from_bits(*bits, *x); }

#include "emitted/quarter_turns.h"
};

/// The steps in double and in float.
template <class Lanes, class Real = typename Lanes::Real>
struct Sines;
template <class Lanes>
struct Sines<Lanes, double> : QuarterTurns<Lanes> {
  using Turns = QuarterTurns<Lanes>;
  using Turns::tl_nearest_quarter;
  using Turns::tl_rotate_by_quarters;
  using Turns::tl_within_range;
  using typename Turns::TlAngle;
  using typename Turns::TlAngleBits;

#include "emitted/remainder_in_double.h"
#include "emitted/sin_cos_in_double.h"
};
template <class Lanes>
struct Sines<Lanes, float> : QuarterTurns<Lanes> {
  using Turns = QuarterTurns<Lanes>;
  using Turns::tl_nearest_quarter;
  using Turns::tl_rotate_by_quarters;
  using Turns::tl_within_range;
  using typename Turns::TlAngle;
  using typename Turns::TlAngleBits;

#include "emitted/remainder_in_float.h"
#include "emitted/sin_cos_in_float.h"
};

/// Sine and cosine in double or float on one lane or several.
template <class Lanes>
TREELINE_INLINE_LANES void sin_cos_steps(const typename Lanes::Value& x,
                                         typename Lanes::Value& sine,
                                         typename Lanes::Value& cosine) noexcept {
  Sines<Lanes>::tl_sin_cos_steps(&x, &sine, &cosine);
}

// Interface.

/// Sine and cosine of `x` radians.
///
/// Error: at most 0.8 ulp for |x| <= 1e5, the hardest doubles near multiples of pi/2 included.
/// Beyond that the remainder has an absolute error of at most 2^-105 up to 2e8; from there to 2^32
/// the result is that of an angle within two units in the last place of `x`; beyond 2^32 it is sine
/// 0 and cosine 1, up to quarter turns. Always within [-1, 1]. sin(-0) = -0. NaN and infinities
/// give NaN. Constant time: no branch and no table.
inline void sin_cos(double x, double& sine, double& cosine) noexcept {
  sin_cos_steps<OneLane<double>>(x, sine, cosine);
}

/// Sine and cosine in float, without one double operation: at most 0.8 ulp for |x| <= 4000 (every
/// such float was tried). Beyond, up to 2^20, the result is that of an angle within one unit in the
/// last place of `x`; beyond 2^20 it is sine 0 and cosine 1.
inline void sin_cos(float x, float& sine, float& cosine) noexcept {
  sin_cos_steps<OneLane<float>>(x, sine, cosine);
}

#if defined(TREELINE_HAS_LANES)
/// Groups of angles side by side.
template <class Number>
struct SineGroups {
  using real = Number;
  static constexpr int TL_ANGLES_AT_ONCE =
      sizeof(real) == sizeof(double) ? kDoublesAtOnce : kFloatsAtOnce;

  TL_INLINE void tl_sin_cos_of(real x, real* sine, real* cosine) {
    sin_cos_steps<OneLane<real>>(x, *sine, *cosine);
  }
  TL_INLINE void tl_fours_sin_cos(const real* x, real* sine, real* cosine) {
    take_group<4>(x, sine, cosine);
  }
  TL_INLINE void tl_eights_sin_cos(const real* x, real* sine, real* cosine) {
    take_group<8>(x, sine, cosine);
  }

#include "emitted/groups_of_angles.h"

 private:
  template <int width>
  TL_INLINE void take_group(const real* x, real* sine, real* cosine) {
    using Group = VectorLanes<real, width>;
    typename Group::Value angle;
    typename Group::Value s;
    typename Group::Value c;
    __builtin_memcpy(&angle, x, sizeof(angle));
    sin_cos_steps<Group>(angle, s, c);
    __builtin_memcpy(sine, &s, sizeof(s));
    __builtin_memcpy(cosine, &c, sizeof(c));
  }
};

template <int N, class Real>
__attribute__((noinline)) void sin_cos_apart(const Real (&x)[N], Real (&sine)[N],
                                             Real (&cosine)[N]) noexcept {
  SineGroups<Real>::tl_sin_cos(N, &x[0], &sine[0], &cosine[0]);
}

/// Sines and cosines of N angles, a group to a vector; the same bits as the scalar function under
/// -ffp-contract=off. The arrays must not overlap. Of many angles the loop stays a loop, apart: a
/// caller with that many joints is long, and bound by its bytes.
template <int N, class Real>
inline void sin_cos(const Real (&x)[N], Real (&sine)[N], Real (&cosine)[N]) noexcept {
  constexpr int kMany = 16;
  if constexpr (N > kMany) {
    sin_cos_apart(x, sine, cosine);
  } else {
    SineGroups<Real>::tl_sin_cos(N, &x[0], &sine[0], &cosine[0]);
  }
}
#else
template <int N, class Real>
inline void sin_cos(const Real (&x)[N], Real (&sine)[N], Real (&cosine)[N]) noexcept {
  for (int i = 0; i < N; ++i) {
    sin_cos(x[i], sine[i], cosine[i]);
  }
}
#endif

#undef TL_INLINE
#undef TREELINE_INLINE_BITS
#undef TREELINE_INLINE_LANES
#undef TREELINE_HAS_LANES
#undef TREELINE_HAS_BIT_CAST

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
