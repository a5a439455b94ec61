// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_SIN_COS_HPP
#define TREELINE_UR10E_SIN_COS_HPP
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

namespace ur10e::detail {

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

#define TREELINE_STEP static TREELINE_INLINE_LANES

/// What takes the bits of numbers, on one lane or several.
template <class Lanes>
struct QuarterTurns {
  using real = typename Lanes::Real;
  using Bits = typename Format<real>::Bits;
  using Angle = typename Lanes::Value;
  using AngleBits = typename Lanes::Bits;
  static constexpr uint32_t kFractionBits = Format<real>::kFractionBits,
                            kSignAt = Format<real>::kSignAt;
  static constexpr Bits kBias = Format<real>::kOne >> kFractionBits,
                          kLargestExponent = Format<real>::kLargestExponent;
  static constexpr real kRoundingShift = Format<real>::kRoundingShift,
                        kTwoOverPi = Format<real>::kTwoOverPi;

  TREELINE_STEP void to_bits(const Angle* x, AngleBits* bits) { Lanes::to_bits(*x, *bits); }
  TREELINE_STEP void from_bits(const AngleBits* bits, Angle* x) { Lanes::from_bits(*bits, *x); }

/// 1 where |x| is within the range, else 0. As a factor it makes infinities and NaN
/// into NaN and keeps everything finite within the polynomials' range. Integers
/// compare as the magnitudes do.
TREELINE_STEP void within_range(const Angle* x, Angle* one_or_zero) {
  const Bits zero = 0;
  const Bits one = 1;
  const Bits bias = kBias;
  const Bits exponent = kLargestExponent;
  const Bits largest = (bias + exponent) << kFractionBits;
  AngleBits bits;
  to_bits(x, &bits);
  bits &= ~(one << kSignAt);
  bits -= largest + one;  // negative, if it could be, within the range
  bits = (zero - (bits >> kSignAt)) & (bias << kFractionBits);
  from_bits(&bits, one_or_zero);
}

/// The nearest multiple of pi/2 to x: `turns` quarter turns, the low bits of
/// `quarter` in two's complement.
TREELINE_STEP void nearest_quarter(
    const Angle* x, Angle* turns, AngleBits* quarter) {
  const real two_over_pi = kTwoOverPi;
  // A number next to it is an integer, so adding it rounds to the nearest integer,
  // whose low bits can be read off, and subtracting it gives the integer back.
  const real rounding_shift = kRoundingShift;
  const Angle shifted = (*x * two_over_pi) + rounding_shift;
  *turns = shifted - rounding_shift;
  to_bits(&shifted, quarter);
}

/// Turns sine and cosine of the remainder into those of the angle: swaps them after
/// an odd number of quarter turns and sets their signs.
TREELINE_STEP void rotate_by_quarters(
    const AngleBits* quarter, Angle* sine, Angle* cosine) {
  const Bits zero = 0;
  const Bits one = 1;
  const Bits sign = one << kSignAt;
  AngleBits s;
  AngleBits c;
  to_bits(sine, &s);
  to_bits(cosine, &c);
  const AngleBits odd = zero - (*quarter & one);
  const AngleBits difference = (s ^ c) & odd;
  s ^= difference ^ ((*quarter << (kSignAt - 1U)) & sign);
  c ^= difference ^ (((*quarter + one) << (kSignAt - 1U)) & sign);
  from_bits(&s, sine);
  from_bits(&c, cosine);
}
};

/// The steps in double and in float.
template <class Lanes, class Real = typename Lanes::Real>
struct Sines;
template <class Lanes>
struct Sines<Lanes, double> : QuarterTurns<Lanes> {
  using Turns = QuarterTurns<Lanes>;
  using Turns::nearest_quarter;
  using Turns::rotate_by_quarters;
  using Turns::within_range;
  using typename Turns::Angle;
  using typename Turns::AngleBits;

/// x - turns pi/2 as r + tail. pi/2 is split in three parts of 26 bits and one of 53:
/// for |turns| < 2^27 the products with the first three are exact, and so are the
/// first two differences (Cody and Waite); what the third loses to rounding goes to
/// `tail`, from which the fourth is taken. Left over: turns * 2^-134, and the
/// rounding of `tail`.
TREELINE_STEP void subtract_quarters(
    const Angle* x, const Angle* turns, Angle* r, Angle* tail) {
  const double kPart1 = 0x1.921fb5p+0;
  const double kPart2 = 0x1.110b46p-26;
  const double kPart3 = 0x1.1a6263p-54;
  const double kPart4 = 0x1.8a2e03707344ap-81;
  const Angle rough = (*x - (*turns * kPart1)) - (*turns * kPart2);
  const Angle third = *turns * kPart3;
  const Angle rest = rough - third;
  *r = rest;
  *tail = ((rough - rest) - third) - (*turns * kPart4);
}

/// Sine and cosine of r + tail, |r| <= pi/4, |tail| of the order of r's rounding.
/// Minimax polynomials in r^2: relative error of the sine 2^-57.9, absolute of the
/// cosine 2^-64. The leading terms r and 1 - r^2/2 are added last and the rounding
/// error of the latter is restored, as in Sun's fdlibm.
TREELINE_STEP void sin_cos_remainder(
    const Angle* r, const Angle* tail, Angle* sine, Angle* cosine) {
  const double kS1 = -0x1.5555555555548p-3;
  const double kS2 = 0x1.111111110f764p-7;
  const double kS3 = -0x1.a01a019bf35dbp-13;
  const double kS4 = 0x1.71de35603d30ep-19;
  const double kS5 = -0x1.ae5e557756731p-26;
  const double kS6 = 0x1.5d8e8400477c8p-33;
  const double kC1 = 0x1.555555555554cp-5;
  const double kC2 = -0x1.6c16c16c1521fp-10;
  const double kC3 = 0x1.a01a019cbf626p-16;
  const double kC4 = -0x1.27e4f812b61f6p-22;
  const double kC5 = 0x1.1ee9f15241a81p-29;
  const double kC6 = -0x1.8fb130c6d769dp-37;
  const Angle z = *r * *r;
  const Angle w = z * z;
  const Angle v = z * *r;
  const Angle s = ((z * kS3) + kS2) + (w * (((z * kS5) + kS4) + (w * kS6)));
  *sine = *r - (((z * ((*tail * 0.5) - (v * s))) - *tail) - (v * kS1));
  const Angle c =
      z * (((z * kC2) + kC1) + (w * (((z * kC4) + kC3) + (w * ((z * kC6) + kC5)))));
  const Angle halved = z * 0.5;
  const Angle leading = 1.0 - halved;
  *cosine = leading + (((1.0 - leading) - halved) + ((z * c) - (*r * *tail)));
}

TREELINE_STEP void sin_cos_steps(const Angle* x, Angle* sine, Angle* cosine) {
  Angle one_or_zero;
  Angle turns;
  Angle r;
  Angle tail;
  AngleBits quarter;
  Angle s;
  Angle c;
  within_range(x, &one_or_zero);
  nearest_quarter(x, &turns, &quarter);
  subtract_quarters(x, &turns, &r, &tail);
  r *= one_or_zero;
  tail *= one_or_zero;
  sin_cos_remainder(&r, &tail, &s, &c);
  rotate_by_quarters(&quarter, &s, &c);
  *sine = s;
  *cosine = c;
}
};
template <class Lanes>
struct Sines<Lanes, float> : QuarterTurns<Lanes> {
  using Turns = QuarterTurns<Lanes>;
  using Turns::nearest_quarter;
  using Turns::rotate_by_quarters;
  using Turns::within_range;
  using typename Turns::Angle;
  using typename Turns::AngleBits;

/// x - turns pi/2 as r - excess. pi/2 is split in parts of 12, 13, 11 and 24 bits:
/// for |turns| <= 2^11 the products with the first three are exact, and so is the
/// first difference. The first parts happen to miss pi/2 by 2^-17.8, 2^-33.9 and
/// 2^-47.4 only. Left over: turns * 2^-72, and the rounding of `excess`, which next
/// to a multiple of pi/2 is 2^-58.
TREELINE_STEP void subtract_quarters(
    const Angle* x, const Angle* turns, Angle* r, Angle* excess) {
  const float kPart1 = 0x1.922p+0F;
  const float kPart2 = -0x1.2afp-18F;
  const float kPart3 = 0x1.0b4p-34F;
  const float kPart4 = 0x1.84698ap-48F;
  const Angle rough = *x - (*turns * kPart1);
  const Angle second = *turns * kPart2;
  const Angle third = *turns * kPart3;
  const Angle rest = second + third;
  const Angle left = rough - rest;
  *r = left;
  *excess = ((third - (rest - second)) + (*turns * kPart4)) - ((rough - left) - rest);
}

/// Sine and cosine of r - excess, |r| <= pi/4: relative error of the sine's
/// polynomial 2^-27.8, absolute of the cosine's 2^-33.1; leading terms are added
/// last.
TREELINE_STEP void sin_cos_remainder(
    const Angle* r, const Angle* excess, Angle* sine, Angle* cosine) {
  const float kS1 = 0x1.555544p-3F;
  const float kS2 = -0x1.1106d6p-7F;
  const float kS3 = 0x1.992462p-13F;
  const float kC1 = 0x1.55554ap-5F;
  const float kC2 = -0x1.6c0c24p-10F;
  const float kC3 = 0x1.99e5cap-16F;
  const Angle z = *r * *r;
  const Angle halved = z * 0.5F;
  const Angle leading = 1.0F - halved;
  const Angle s = (((z * kS3) + kS2) * z) + kS1;
  *sine = *r - ((*excess * leading) + ((z * *r) * s));
  const Angle c = (((z * kC3) + kC2) * z) + kC1;
  *cosine =
      leading + (((1.0F - leading) - halved) + (((z * z) * c) + (*r * *excess)));
}

TREELINE_STEP void sin_cos_steps(const Angle* x, Angle* sine, Angle* cosine) {
  Angle one_or_zero;
  Angle turns;
  Angle r;
  Angle excess;
  AngleBits quarter;
  Angle s;
  Angle c;
  within_range(x, &one_or_zero);
  const Angle angle = *x * one_or_zero;
  nearest_quarter(&angle, &turns, &quarter);
  subtract_quarters(&angle, &turns, &r, &excess);
  sin_cos_remainder(&r, &excess, &s, &c);
  rotate_by_quarters(&quarter, &s, &c);
  *sine = s;
  *cosine = c;
}
};

/// Sine and cosine in double or float on one lane or several.
template <class Lanes>
TREELINE_INLINE_LANES void sin_cos_steps(const typename Lanes::Value& x,
                                         typename Lanes::Value& sine,
                                         typename Lanes::Value& cosine) noexcept {
  Sines<Lanes>::sin_cos_steps(&x, &sine, &cosine);
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
  static constexpr int kAnglesAtOnce =
      sizeof(real) == sizeof(double) ? kDoublesAtOnce : kFloatsAtOnce;

  TREELINE_STEP void sin_cos_of(real x, real* sine, real* cosine) {
    sin_cos_steps<OneLane<real>>(x, *sine, *cosine);
  }
  TREELINE_STEP void fours_sin_cos(const real* x, real* sine, real* cosine) {
    take_group<4>(x, sine, cosine);
  }
  TREELINE_STEP void eights_sin_cos(const real* x, real* sine, real* cosine) {
    take_group<8>(x, sine, cosine);
  }

/// Sines and cosines of several angles. Of many, the last eight take some a second
/// time: a remainder would make the code long. Of few, two or three that remain are
/// padded.
TREELINE_STEP void sin_cos(int32_t count, const real* x, real* sine, real* cosine) {
  int32_t done = 0;
  if (kAnglesAtOnce == 8) {
    done = (count > 16) ? count : count - (count % 8);
    for (int32_t i = 0; i < done; i += 8) {
      const int32_t at = (i + 8 <= count) ? i : count - 8;
      eights_sin_cos(&x[at], &sine[at], &cosine[at]);
    }
  }
  const int32_t whole = (done < count) ? count - (count % 4) : count;
  for (int32_t i = done; i < whole; i += 4) {
    fours_sin_cos(&x[i], &sine[i], &cosine[i]);
  }
  const int32_t left = count - whole;
  if (left == 1) {
    sin_cos_of(x[whole], &sine[whole], &cosine[whole]);
  } else if (left > 1) {
    const real angles[4] = {x[whole], x[whole + 1], x[count - 1], x[whole]};
    real sines[4];
    real cosines[4];
    fours_sin_cos(angles, sines, cosines);
    sine[whole] = sines[0];
    cosine[whole] = cosines[0];
    sine[whole + 1] = sines[1];
    cosine[whole + 1] = cosines[1];
    if (left == 3) {
      sine[whole + 2] = sines[2];
      cosine[whole + 2] = cosines[2];
    }
  }
}

 private:
  template <int width>
  TREELINE_STEP void take_group(const real* x, real* sine, real* cosine) {
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
  SineGroups<Real>::sin_cos(N, &x[0], &sine[0], &cosine[0]);
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
    SineGroups<Real>::sin_cos(N, &x[0], &sine[0], &cosine[0]);
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

#undef TREELINE_STEP
#undef TREELINE_INLINE_BITS
#undef TREELINE_INLINE_LANES
#undef TREELINE_HAS_LANES
#undef TREELINE_HAS_BIT_CAST

}  // namespace ur10e::detail

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif  // TREELINE_UR10E_SIN_COS_HPP
