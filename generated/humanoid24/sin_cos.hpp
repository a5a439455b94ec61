#pragma once
// Sine and cosine together, without branch, table, heap or library: C++17, freestanding, one file.
// Every generated folder carries its own copy, in a namespace of its own, so that robots generated
// at different times live in one program.
//
// Every operation is one IEEE operation in round-to-nearest, and the order of operations matters:
// compile without -ffast-math and its parts (-fassociative-math, -ffinite-math-only, ...), which
// would cancel the rounding trick away. -ffp-contract may be on or off: no step relies on a fused
// multiply-add and none is spoilt by one. With it off, all lanes and the scalar function give the
// same bits.

#include <cstdint>

namespace humanoid24::detail {

// Lanes: one number or several, under one set of names.

/// One double with the 64 bits it is made of.
struct OneLane {
  using Value = double;
  using Bits = std::uint64_t;
  static void to_bits(const Value& value, Bits& bits) noexcept { copy(value, bits); }
  static void from_bits(const Bits& bits, Value& value) noexcept { copy(bits, value); }
  static void less_equal(const Value& a, double b, Bits& mask) noexcept {
    mask = std::uint64_t{0} - static_cast<std::uint64_t>(a <= b);
  }

 private:
  template <class From, class To>
  static void copy(const From& from, To& to) noexcept {
    static_assert(sizeof(From) == sizeof(To));
#if defined(__GNUC__)
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

// Only where there are wide registers: elsewhere the extension would be unpacked again.
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && \
    !defined(TREELINE_NO_VECTOR_EXTENSIONS)
#define TREELINE_HAS_LANES
#define TREELINE_INLINE_LANES inline __attribute__((always_inline))
/// Doubles side by side. What is wider than the target's registers becomes several operations.
/// Passed by reference only: the calling convention of such a value depends on the target's flags.
template <int count>
struct VectorLanes {
  typedef double Value __attribute__((vector_size(count * sizeof(double))));
  typedef std::uint64_t Bits __attribute__((vector_size(count * sizeof(double))));

  static TREELINE_INLINE_LANES void to_bits(const Value& value, Bits& bits) noexcept {
    bits = (Bits)value;
  }
  static TREELINE_INLINE_LANES void from_bits(const Bits& bits, Value& value) noexcept {
    value = (Value)bits;
  }
  static TREELINE_INLINE_LANES void less_equal(const Value& a, double b, Bits& mask) noexcept {
    mask = (Bits)(a <= (Value{} + b));
  }
};

/// Four doubles: of one state, four are faster than eight even where eight fit a register.
struct FourLanes : VectorLanes<4> {
  typedef float Single __attribute__((vector_size(16)));
  static constexpr int kCount = 4;

  /// Reads `count` of four angles; the lanes left over repeat the first.
  template <int count>
  static TREELINE_INLINE_LANES void load(const double* from, Value& value) noexcept {
    if constexpr (count == kCount) {
      __builtin_memcpy(&value, from, sizeof(value));
    } else {
      value = Value{from[0], from[count > 1 ? 1 : 0], from[count > 2 ? 2 : 0], from[0]};
    }
  }
  template <int count>
  static TREELINE_INLINE_LANES void load(const float* from, Value& value) noexcept {
    Single narrow;
    if constexpr (count == kCount) {
      __builtin_memcpy(&narrow, from, sizeof(narrow));
    } else {
      narrow = Single{from[0], from[count > 1 ? 1 : 0], from[count > 2 ? 2 : 0], from[0]};
    }
    value = __builtin_convertvector(narrow, Value);
  }
  template <int count>
  static TREELINE_INLINE_LANES void store(const Value& value, double* to) noexcept {
    __builtin_memcpy(to, &value, count * sizeof(double));
  }
  template <int count>
  static TREELINE_INLINE_LANES void store(const Value& value, float* to) noexcept {
    const Single narrow = __builtin_convertvector(value, Single);
    __builtin_memcpy(to, &narrow, count * sizeof(float));
  }
};
#else
#define TREELINE_INLINE_LANES inline
#endif

// Steps.

/// 1.5 * 2^52: a double next to it is an integer, so adding it rounds to the nearest integer, whose
/// low bits can be read off, and subtracting it gives the integer back.
inline constexpr double kRoundingShift = 6755399441055744.0;
inline constexpr double kTwoOverPi = 0.6366197723675814;
/// Angles beyond this (2^32 rad) count as 0.
inline constexpr double kLargestAngle = 4294967296.0;
inline constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;

/// The nearest multiple of pi/2 to `x`: `turns` quarter turns, the low bits of `quarter` in two's
/// complement.
template <class Lanes>
TREELINE_INLINE_LANES void nearest_quarter(const typename Lanes::Value& x,
                                           typename Lanes::Value& turns,
                                           typename Lanes::Bits& quarter) noexcept {
  const typename Lanes::Value shifted = x * kTwoOverPi + kRoundingShift;
  turns = shifted - kRoundingShift;
  Lanes::to_bits(shifted, quarter);
}

/// 1 where |x| <= kLargestAngle, else 0. As a factor it makes infinities and NaN into NaN and keeps
/// everything finite within the polynomials' range.
template <class Lanes>
TREELINE_INLINE_LANES void within_range(const typename Lanes::Value& x,
                                        typename Lanes::Value& one_or_zero) noexcept {
  typename Lanes::Bits bits;
  typename Lanes::Bits mask;
  typename Lanes::Value magnitude;
  Lanes::to_bits(x, bits);
  bits &= ~kSignBit;
  Lanes::from_bits(bits, magnitude);
  Lanes::less_equal(magnitude, kLargestAngle, mask);
  constexpr std::uint64_t kOne = std::uint64_t{1023} << 52;
  mask &= kOne;
  Lanes::from_bits(mask, one_or_zero);
}

/// Turns sine and cosine of the remainder into those of the angle: swaps them after an odd number
/// of quarter turns and sets their signs.
template <class Lanes>
TREELINE_INLINE_LANES void rotate_by_quarters(const typename Lanes::Bits& quarter,
                                              typename Lanes::Value& sine,
                                              typename Lanes::Value& cosine) noexcept {
  typename Lanes::Bits s;
  typename Lanes::Bits c;
  Lanes::to_bits(sine, s);
  Lanes::to_bits(cosine, c);
  const typename Lanes::Bits odd = std::uint64_t{0} - (quarter & std::uint64_t{1});
  const typename Lanes::Bits difference = (s ^ c) & odd;
  s ^= difference ^ ((quarter << 62) & kSignBit);
  c ^= difference ^ (((quarter + std::uint64_t{1}) << 62) & kSignBit);
  Lanes::from_bits(s, sine);
  Lanes::from_bits(c, cosine);
}

/// x - turns pi/2 as `r + tail`. pi/2 is split in three parts of 26 bits and one of 53: for
/// |turns| < 2^27 the products with the first three are exact, and so are the first two differences
/// (Cody and Waite); what the third loses to rounding goes to `tail`, from which the fourth is
/// taken. Left over: turns * 2^-134, and the rounding of `tail`.
template <class Lanes>
TREELINE_INLINE_LANES void subtract_quarters(const typename Lanes::Value& x,
                                             const typename Lanes::Value& turns,
                                             typename Lanes::Value& r,
                                             typename Lanes::Value& tail) noexcept {
  constexpr double kPart1 = 0x1.921fb5p+0;
  constexpr double kPart2 = 0x1.110b46p-26;
  constexpr double kPart3 = 0x1.1a6263p-54;
  constexpr double kPart4 = 0x1.8a2e03707344ap-81;
  const typename Lanes::Value rough = (x - turns * kPart1) - turns * kPart2;
  const typename Lanes::Value third = turns * kPart3;
  r = rough - third;
  tail = ((rough - r) - third) - turns * kPart4;
}

/// Sine and cosine of `r + tail`, |r| <= pi/4, |tail| of the order of r's rounding. Minimax
/// polynomials in r^2: relative error of the sine 2^-57.9, absolute of the cosine 2^-64. The
/// leading terms r and 1 - r^2/2 are added last and the rounding error of the latter is restored,
/// as in Sun's fdlibm.
template <class Lanes>
TREELINE_INLINE_LANES void sin_cos_remainder(const typename Lanes::Value& r,
                                             const typename Lanes::Value& tail,
                                             typename Lanes::Value& sine,
                                             typename Lanes::Value& cosine) noexcept {
  using Value = typename Lanes::Value;
  constexpr double kS1 = -0x1.5555555555548p-3;
  constexpr double kS2 = 0x1.111111110f764p-7;
  constexpr double kS3 = -0x1.a01a019bf35dbp-13;
  constexpr double kS4 = 0x1.71de35603d30ep-19;
  constexpr double kS5 = -0x1.ae5e557756731p-26;
  constexpr double kS6 = 0x1.5d8e8400477c8p-33;
  constexpr double kC1 = 0x1.555555555554cp-5;
  constexpr double kC2 = -0x1.6c16c16c1521fp-10;
  constexpr double kC3 = 0x1.a01a019cbf626p-16;
  constexpr double kC4 = -0x1.27e4f812b61f6p-22;
  constexpr double kC5 = 0x1.1ee9f15241a81p-29;
  constexpr double kC6 = -0x1.8fb130c6d769dp-37;
  const Value z = r * r;
  const Value w = z * z;
  const Value v = z * r;
  const Value s = (z * kS3 + kS2) + w * ((z * kS5 + kS4) + w * kS6);
  sine = r - ((z * (tail * 0.5 - v * s) - tail) - v * kS1);
  const Value c = z * ((z * kC2 + kC1) + w * ((z * kC4 + kC3) + w * (z * kC6 + kC5)));
  const Value half = z * 0.5;
  const Value leading = 1.0 - half;
  cosine = leading + (((1.0 - leading) - half) + (z * c - r * tail));
}

/// The double function on one lane or several.
template <class Lanes>
TREELINE_INLINE_LANES void sin_cos_double(const typename Lanes::Value& x,
                                          typename Lanes::Value& sine,
                                          typename Lanes::Value& cosine) noexcept {
  typename Lanes::Value turns;
  typename Lanes::Value r;
  typename Lanes::Value tail;
  typename Lanes::Value one_or_zero;
  typename Lanes::Bits quarter;
  nearest_quarter<Lanes>(x, turns, quarter);
  within_range<Lanes>(x, one_or_zero);
  subtract_quarters<Lanes>(x, turns, r, tail);
  sin_cos_remainder<Lanes>(r * one_or_zero, tail * one_or_zero, sine, cosine);
  rotate_by_quarters<Lanes>(quarter, sine, cosine);
}

/// The float function, on floats widened to double: the remainder in one double needs no tail
/// (turns * part exact for |turns| < 2^26), and shorter polynomials do: relative error of the sine
/// 2^-37.5, absolute of the cosine 2^-34.1.
template <class Lanes>
TREELINE_INLINE_LANES void sin_cos_float(const typename Lanes::Value& x,
                                         typename Lanes::Value& sine,
                                         typename Lanes::Value& cosine) noexcept {
  using Value = typename Lanes::Value;
  constexpr double kPart1 = 0x1.921fb54p+0;
  constexpr double kPart2 = 0x1.10b4611a62633p-30;
  constexpr double kS1 = -0x1.5555554c71ca0p-3;
  constexpr double kS2 = 0x1.1111086a5c686p-7;
  constexpr double kS3 = -0x1.a00f7f2506254p-13;
  constexpr double kS4 = 0x1.6cd1f1d67a4f2p-19;
  constexpr double kC1 = -0x1.ffffffd0c6103p-2;
  constexpr double kC2 = 0x1.55553e1062132p-5;
  constexpr double kC3 = -0x1.6c087e86a162ap-10;
  constexpr double kC4 = 0x1.99342f645461bp-16;
  Value turns;
  Value one_or_zero;
  typename Lanes::Bits quarter;
  nearest_quarter<Lanes>(x, turns, quarter);
  within_range<Lanes>(x, one_or_zero);
  const Value r = ((x - turns * kPart1) - turns * kPart2) * one_or_zero;
  const Value z = r * r;
  const Value w = z * z;
  sine = r * (((z * kS2 + kS1) + w * (z * kS4 + kS3)) * z + 1.0);
  cosine = ((z * kC2 + kC1) + w * (z * kC4 + kC3)) * z + 1.0;
  rotate_by_quarters<Lanes>(quarter, sine, cosine);
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
  sin_cos_double<OneLane>(x, sine, cosine);
}

/// The same for float, evaluated in double: at most 0.51 ulp for |x| <= 1e8; beyond as above.
inline void sin_cos(float x, float& sine, float& cosine) noexcept {
  double s;
  double c;
  sin_cos_float<OneLane>(static_cast<double>(x), s, c);
  sine = static_cast<float>(s);
  cosine = static_cast<float>(c);
}

#if defined(TREELINE_HAS_LANES)
TREELINE_INLINE_LANES void sin_cos_lanes(const double*, const FourLanes::Value& x,
                                         FourLanes::Value& sine,
                                         FourLanes::Value& cosine) noexcept {
  sin_cos_double<FourLanes>(x, sine, cosine);
}
TREELINE_INLINE_LANES void sin_cos_lanes(const float*, const FourLanes::Value& x,
                                         FourLanes::Value& sine,
                                         FourLanes::Value& cosine) noexcept {
  sin_cos_float<FourLanes>(x, sine, cosine);
}

/// `count` <= 4 angles from `x` on.
template <int count, class Real>
TREELINE_INLINE_LANES void sin_cos_group(const Real* x, Real* sine, Real* cosine) noexcept {
  FourLanes::Value angle;
  FourLanes::Value s;
  FourLanes::Value c;
  FourLanes::load<count>(x, angle);
  sin_cos_lanes(x, angle, s, c);
  FourLanes::store<count>(s, sine);
  FourLanes::store<count>(c, cosine);
}

template <int N, class Real>
TREELINE_INLINE_LANES void sin_cos_groups(const Real (&x)[N], Real (&sine)[N],
                                          Real (&cosine)[N]) noexcept {
  constexpr int kWhole = N - N % FourLanes::kCount;
  for (int i = 0; i < kWhole; i += FourLanes::kCount) {
    sin_cos_group<FourLanes::kCount>(x + i, sine + i, cosine + i);
  }
  if constexpr (N != kWhole) {
    sin_cos_group<N - kWhole>(x + kWhole, sine + kWhole, cosine + kWhole);
  }
}

template <int N, class Real>
__attribute__((noinline)) void sin_cos_apart(const Real (&x)[N], Real (&sine)[N],
                                             Real (&cosine)[N]) noexcept {
  sin_cos_groups(x, sine, cosine);
}

/// Sines and cosines of N angles, four to a vector, the last group padded; the same bits as the
/// scalar function under -ffp-contract=off. The arrays must not overlap. Of many angles the loop
/// stays a loop, apart: a caller with that many joints is long, and bound by its bytes.
template <int N, class Real>
inline void sin_cos(const Real (&x)[N], Real (&sine)[N], Real (&cosine)[N]) noexcept {
  constexpr int kMany = 16;
  if constexpr (N > kMany) {
    sin_cos_apart(x, sine, cosine);
  } else {
    sin_cos_groups(x, sine, cosine);
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

#undef TREELINE_INLINE_LANES
#undef TREELINE_HAS_LANES

}  // namespace humanoid24::detail
