// Accuracy of sine and cosine: doubles are compared with glibc's functions of 64-bit mantissa
// (whose error is below 2^-10 ulp of a double), floats with glibc's doubles, and the hardest cases
// with Boost's 100 digits, which also check the former. Lanes must agree exactly with the scalar
// function. Special values are included. Would catch: a wrong digit in a constant, a lost tail of
// the reduction, a wrong quadrant or sign, lanes that are mixed up, a remainder lane that reads
// past the end, and a compiler that reassociates.
#include "core/sin_cos.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "ulp.hpp"

namespace {

using treeline::core::sin_cos;
using treeline::test::ulps;
using Digits100 = boost::multiprecision::cpp_bin_float_100;

constexpr std::uint64_t kSeed = 20240305;

/// Largest error found, and where it occurs.
struct Worst {
  double error = 0.0;
  double angle = 0.0;
  void take(double candidate, double at) {
    if (!(candidate <= error)) {
      error = candidate;
      angle = at;
    }
  }
};

/// The larger error of sine and cosine, with `Wide` as reference.
template <class Wide, class Real>
double error_at(Real x) {
  using std::cos;
  using std::sin;
  Real s;
  Real c;
  sin_cos(x, s, c);
  const Wide exact(x);
  return std::max(ulps(s, Wide(sin(exact))), ulps(c, Wide(cos(exact))));
}

void report(const char* what, const Worst& worst) {
  std::printf("%s: at most %.4f ulp, at %a (%.17g)\n", what, worst.error, worst.angle, worst.angle);
}

bool long_double_is_wide() {
  return std::numeric_limits<long double>::digits >= 64;
}

template <class Real>
bool same_bits(Real a, Real b) {
  return std::memcmp(&a, &b, sizeof(Real)) == 0;
}

// Bound: half an ulp from the last addition; the rounding of the added terms, which are at most an
// eighth of the result and contain about 1.5 roundings each; polynomial error 0.035 ulp. In sum
// 0.8.
TEST(SinCosDouble, IsWithin08UlpUpTo1e5) {
  if (!long_double_is_wide()) {
    GTEST_SKIP() << "long double is no wider than double here";
  }
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> joint(-4.0, 4.0);
  std::uniform_real_distribution<double> wide(-1e5, 1e5);
  std::uniform_real_distribution<double> exponent(-60.0, 16.6);
  Worst worst;
  for (int i = 0; i < 350000; ++i) {
    for (const double x : {joint(random), wide(random), std::exp2(exponent(random))}) {
      worst.take(error_at<long double>(x), x);
    }
  }
  report("double, |x| <= 1e5", worst);
  EXPECT_LT(worst.error, 0.8) << "seed " << kSeed;
}

// The doubles nearest to every multiple of pi/2 up to 1e5 contain the hardest cases: the remainder
// loses up to 60 bits there.
TEST(SinCosDouble, IsWithin08UlpNextToMultiplesOfHalfPi) {
  const Digits100 half_pi = boost::math::constants::half_pi<Digits100>();
  Worst bulk;
  Worst hardest;
  for (int n = 1; n <= 63661; ++n) {
    const Digits100 multiple = half_pi * n;
    const double nearest = static_cast<double>(multiple);
    for (const double x : {nearest, -nearest, std::nextafter(nearest, 0.0)}) {
      if (long_double_is_wide()) {
        bulk.take(error_at<long double>(x), x);
      }
    }
    if (abs(Digits100(nearest) - multiple) < 1e-4 * std::numeric_limits<double>::epsilon() * n) {
      hardest.take(error_at<Digits100>(nearest), nearest);
    }
  }
  report("double, next to n pi/2", bulk);
  report("double, closest to n pi/2", hardest);
  EXPECT_LT(bulk.error, 0.8);
  EXPECT_LT(hardest.error, 0.8);
  EXPECT_GT(hardest.angle, 0.0) << "no hard case was met";
}

TEST(SinCosDouble, AgreesWith100Digits) {
  std::mt19937_64 random(kSeed + 1);
  std::uniform_real_distribution<double> wide(-1e5, 1e5);
  Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const double x = i % 2 == 0 ? wide(random) : wide(random) * 1e-4;
    worst.take(error_at<Digits100>(x), x);
  }
  report("double, 100 digits", worst);
  EXPECT_LT(worst.error, 0.8) << "seed " << kSeed + 1;
}

// Up to 2e8 the absolute error of the remainder is 2^-105, which random angles cannot reveal.
TEST(SinCosDouble, HoldsUpTo2e8) {
  std::mt19937_64 random(kSeed + 2);
  std::uniform_real_distribution<double> wide(-2e8, 2e8);
  Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const double x = wide(random);
    worst.take(error_at<Digits100>(x), x);
  }
  report("double, |x| <= 2e8", worst);
  EXPECT_LT(worst.error, 0.8) << "seed " << kSeed + 2;
}

// Beyond that: the result of an angle within two units in the last place of x, up to 2^32.
TEST(SinCosDouble, DegradesAsAnAngleAFewUnitsOff) {
  std::mt19937_64 random(kSeed + 3);
  std::uniform_real_distribution<double> exponent(27.0, 32.0);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::exp2(exponent(random));
    const double spacing = std::nextafter(x, HUGE_VAL) - x;
    double s;
    double c;
    sin_cos(x, s, c);
    EXPECT_LE(abs(Digits100(s) - sin(Digits100(x))), 2.0 * spacing) << x;
    EXPECT_LE(abs(Digits100(c) - cos(Digits100(x))), 2.0 * spacing) << x;
  }
}

TEST(SinCosDouble, TinyAnglesAreTheirOwnSine) {
  for (double x = 0x1p-27; x > 0.0; x *= 0.5) {
    for (const double angle : {x, -x}) {
      double s;
      double c;
      sin_cos(angle, s, c);
      EXPECT_EQ(s, angle);
      EXPECT_EQ(c, 1.0);
    }
  }
}

template <class Real>
void expect_special_values() {
  Real s;
  Real c;
  sin_cos(Real(0), s, c);
  EXPECT_TRUE(same_bits(s, Real(0)));
  EXPECT_EQ(c, Real(1));
  sin_cos(-Real(0), s, c);
  EXPECT_TRUE(same_bits(s, -Real(0)));
  EXPECT_EQ(c, Real(1));
  using Limits = std::numeric_limits<Real>;
  for (const Real bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    sin_cos(bad, s, c);
    EXPECT_TRUE(std::isnan(s)) << bad;
    EXPECT_TRUE(std::isnan(c)) << bad;
  }
  for (Real x = Real(1); std::isfinite(x); x *= Real(1.0625)) {
    sin_cos(x, s, c);
    EXPECT_LE(std::fabs(s), Real(1)) << x;
    EXPECT_LE(std::fabs(c), Real(1)) << x;
    EXPECT_NEAR(s * s + c * c, 1.0, 8.0 * Limits::epsilon()) << x;
  }
  sin_cos(Limits::max(), s, c);
  EXPECT_TRUE(std::isfinite(s) && std::isfinite(c));
}

TEST(SinCosDouble, SpecialValues) {
  expect_special_values<double>();
}
TEST(SinCosFloat, SpecialValues) {
  expect_special_values<float>();
}

float float_from_bits(std::uint32_t bits) {
  float x;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}

std::uint32_t bits_of(float x) {
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof(x));
  return bits;
}

// Every 1009th float up to 4000 with both signs, and the floats near multiples of pi/2, where the
// remainder loses up to 27 bits. The program sin_cos_exhaustive tries all floats. Bound: half an
// ulp from the last addition; for the cosine a quarter more, from squaring the remainder; the terms
// before, at most a tenth of the result, contain a few roundings.
TEST(SinCosFloat, IsWithin08UlpUpTo4000) {
  Worst worst;
  for (std::uint32_t bits = 0; bits <= bits_of(4000.0F); bits += 1009) {
    const float x = float_from_bits(bits);
    worst.take(error_at<double>(x), static_cast<double>(x));
    worst.take(error_at<double>(-x), static_cast<double>(-x));
  }
  for (int n = 1; n <= 2546; ++n) {
    const float nearest = static_cast<float>(n * 1.5707963267948966);
    for (const float x : {nearest, std::nextafter(nearest, 0.0F), std::nextafter(nearest, 1e9F)}) {
      worst.take(error_at<double>(x), static_cast<double>(x));
      worst.take(error_at<double>(-x), static_cast<double>(-x));
    }
  }
  report("float, |x| <= 4000", worst);
  EXPECT_LT(worst.error, 0.8);
}

// The floats with the largest errors or the smallest remainders when all were tried.
TEST(SinCosFloat, HardestFloatsAreWithin08Ulp) {
  Worst worst;
  for (const float x : {0x1.0d5e9ap+8F, 0x1.a1d5d2p-1F, 0x1.9fe228p-1F, 0x1.921fb6p+0F}) {
    worst.take(error_at<Digits100>(x), static_cast<double>(x));
    worst.take(error_at<Digits100>(-x), static_cast<double>(-x));
  }
  report("float, hardest", worst);
  EXPECT_LT(worst.error, 0.8);
  EXPECT_GT(worst.error, 0.75) << "not the hardest";
}

// Beyond that: the result of an angle within one unit in the last place of x, up to 2^20.
TEST(SinCosFloat, DegradesAsAnAngleAUnitOff) {
  for (std::uint32_t bits = bits_of(4000.0F); bits <= bits_of(0x1p+20F); bits += 101) {
    const float x = float_from_bits(bits);
    const double spacing = static_cast<double>(std::nextafter(x, HUGE_VALF) - x);
    float s;
    float c;
    sin_cos(x, s, c);
    ASSERT_LE(std::fabs(static_cast<double>(s) - std::sin(static_cast<double>(x))), spacing) << x;
    ASSERT_LE(std::fabs(static_cast<double>(c) - std::cos(static_cast<double>(x))), spacing) << x;
  }
}

// Subnormal and tiny floats are returned unchanged, with the sign of zero.
TEST(SinCosFloat, TinyAnglesAreTheirOwnSine) {
  for (float x = 0x1p-13F; x > 0.0F; x *= 0.5F) {
    for (const float angle : {x, -x}) {
      float s;
      float c;
      sin_cos(angle, s, c);
      EXPECT_EQ(s, angle);
      EXPECT_EQ(c, 1.0F);
    }
  }
}

template <int N, class Real>
void expect_lanes_match(std::mt19937_64& random) {
  std::uniform_real_distribution<double> wide(-100.0, 100.0);
  for (int round = 0; round < 200; ++round) {
    Real x[N];
    Real s[N];
    Real c[N];
    for (Real& angle : x) {
      angle = static_cast<Real>(wide(random) * (round % 3 == 0 ? 1e3 : 0.05));
    }
    sin_cos(x, s, c);
    for (int i = 0; i < N; ++i) {
      Real sine;
      Real cosine;
      sin_cos(x[i], sine, cosine);
      EXPECT_TRUE(same_bits(s[i], sine)) << N << " angles, lane " << i << ": " << x[i];
      EXPECT_TRUE(same_bits(c[i], cosine)) << N << " angles, lane " << i << ": " << x[i];
    }
  }
}

template <class Real>
void expect_all_widths_match() {
  std::mt19937_64 random(kSeed + 4);
  expect_lanes_match<1, Real>(random);
  expect_lanes_match<2, Real>(random);
  expect_lanes_match<3, Real>(random);
  expect_lanes_match<4, Real>(random);
  expect_lanes_match<5, Real>(random);
  expect_lanes_match<6, Real>(random);
  expect_lanes_match<7, Real>(random);
  expect_lanes_match<8, Real>(random);
  expect_lanes_match<11, Real>(random);
  expect_lanes_match<15, Real>(random);
  expect_lanes_match<17, Real>(random);
  expect_lanes_match<24, Real>(random);
  expect_lanes_match<59, Real>(random);
}

TEST(SinCosDouble, LanesGiveTheScalarBits) {
  expect_all_widths_match<double>();
}
TEST(SinCosFloat, LanesGiveTheScalarBits) {
  expect_all_widths_match<float>();
}

// A NaN in one lane must not affect the other lanes.
template <class Real>
void expect_independent_lanes() {
  using Limits = std::numeric_limits<Real>;
  const Real x[4] = {Real(0.5), Limits::quiet_NaN(), Limits::max(), Real(-0.0)};
  Real s[4];
  Real c[4];
  sin_cos(x, s, c);
  EXPECT_NEAR(s[0], std::sin(0.5), Limits::epsilon());
  EXPECT_TRUE(std::isnan(s[1]));
  EXPECT_LE(std::fabs(s[2]), Real(1));
  EXPECT_TRUE(same_bits(s[3], Real(-0.0)));
  EXPECT_EQ(c[3], Real(1));
}

TEST(SinCosDouble, LanesAreIndependent) {
  expect_independent_lanes<double>();
}
TEST(SinCosFloat, LanesAreIndependent) {
  expect_independent_lanes<float>();
}

}  // namespace
