#include "digits/digits50.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>
#include <string>

// Sums and products are computed limb by limb, and compared with Boost's arithmetic to the bit.
// Would catch: a wrong carry, a tie that is not rounded to even, and bits lost in alignment. Sines
// are compared with Boost's series, up to the last digits.

namespace treeline {
namespace {

using Boost = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                            boost::multiprecision::et_off>;

/// A number in both types, made from doubles, which both convert exactly.
struct Twin {
  Digits50 own;
  Boost boost;
};

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}

  /// Sums of several doubles, each somewhat smaller than the one before. Powers of two among them
  /// cause runs of ones and zeros, and the carries that end them.
  Twin draw(int largest_exponent) {
    Twin twin{0, 0};
    int exponent = std::uniform_int_distribution(-largest_exponent, largest_exponent)(random_);
    for (int i = 0; i < 5; ++i) {
      const bool whole = std::uniform_int_distribution(0, 2)(random_) == 0;
      double part = whole ? 1 : std::uniform_real_distribution(0.5, 1.0)(random_);
      part = std::ldexp(part, exponent);
      if (std::uniform_int_distribution(0, 1)(random_) == 0) part = -part;
      twin.boost += part;
      twin.own = exactly(twin.boost);
      exponent -= std::uniform_int_distribution(1, 80)(random_);
    }
    return twin;
  }

  /// Boost's number as a sum of doubles, each of which is the rounded rest.
  static Digits50 exactly(Boost value) {
    Digits50 sum = 0;
    while (value != 0) {
      const auto part = static_cast<double>(value);
      sum += part;
      value -= part;
    }
    return sum;
  }

 private:
  std::mt19937_64 random_;
};

template <class Number>
std::string text(const Number& x) {
  std::ostringstream stream;
  stream << std::setprecision(60) << x;
  return stream.str();
}

TEST(Digits50, SumsDifferencesAndProductsAreBoosts) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Numbers numbers(kSeed);
  for (int i = 0; i < 50'000; ++i) {
    const int exponent = i % 2 == 0 ? 4 : 120;
    const Twin a = numbers.draw(exponent), b = numbers.draw(exponent);
    ASSERT_EQ(text(a.own), text(a.boost));
    ASSERT_EQ(text(a.own + b.own), text(Boost(a.boost + b.boost))) << text(a.own) << text(b.own);
    ASSERT_EQ(text(a.own - b.own), text(Boost(a.boost - b.boost))) << text(a.own) << text(b.own);
    const Digits50 own_sum = a.own + b.own;
    const Boost boost_sum = a.boost + b.boost;
    ASSERT_EQ(text(own_sum - a.own), text(Boost(boost_sum - a.boost)))
        << text(a.own) << text(b.own);
    ASSERT_EQ(text(a.own * b.own), text(Boost(a.boost * b.boost))) << text(a.own) << text(b.own);
  }
}

/// Would catch: a zero with the wrong sign, a term that is lost beside one.
TEST(Digits50, SumsAndProductsWithZerosAreBoosts) {
  for (const double a : {0.0, -0.0, 1.5, -2.0}) {
    for (const double b : {0.0, -0.0, 3.0, -0.25}) {
      SCOPED_TRACE(testing::Message() << a << " and " << b);
      EXPECT_EQ(text(Digits50(a) + Digits50(b)), text(Boost(Boost(a) + Boost(b))));
      EXPECT_EQ(text(Digits50(a) - Digits50(b)), text(Boost(Boost(a) - Boost(b))));
      EXPECT_EQ(text(Digits50(a) * Digits50(b)), text(Boost(Boost(a) * Boost(b))));
      Digits50 twice = a;
      twice += twice;
      EXPECT_EQ(text(twice), text(Boost(2 * Boost(a))));
    }
  }
  EXPECT_EQ(text(Digits50(-0.0)), "-0");
}

/// Would catch: a bit in the wrong place, the smallest doubles, whose 53 bits are not all there.
TEST(Digits50, DoublesAreExact) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20'000; ++i) {
    const auto x = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (std::isnan(x)) continue;
    ASSERT_EQ(text(Digits50(x)), text(Boost(x)));
    ASSERT_EQ(static_cast<double>(Digits50(x)), x);
  }
  for (const double x : {5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308,
                         std::numeric_limits<double>::infinity(), 1.0, 0.1}) {
    EXPECT_EQ(text(Digits50(x)), text(Boost(x)));
  }
}

/// Would catch: an integer that has been rounded to a double on its way.
TEST(Digits50, IntegersAreExact) {
  constexpr long long kMost = std::numeric_limits<long long>::max();
  for (const long long x :
       {0LL, 1LL, -7LL, 1LL << 53, (1LL << 53) + 1, -(1LL << 53) - 1, kMost, -kMost, -kMost - 1}) {
    EXPECT_EQ(text(Digits50(x)), text(Boost(x)));
  }
}

TEST(Digits50, DifferencesOfNeighboursAreExact) {
  const Digits50 one = 1;
  Digits50 ulp = 1;
  for (int i = 0; i < 167; ++i) ulp *= 0.5;
  EXPECT_EQ(one + ulp - one, ulp);
  EXPECT_EQ(one + ulp * Digits50(0.5), one);                  // a tie: to even
  EXPECT_EQ(one + ulp + ulp * Digits50(0.5), one + ulp * 2);  // and away from odd
  EXPECT_EQ(one - ulp * Digits50(0.25), one);                 // a tie below a power of two
  EXPECT_EQ(one - one, Digits50(0));
  EXPECT_EQ(Digits50(3) - Digits50(3) + one, one);
}

/// Would catch: angles that are reduced with too few digits of pi, a wrong quadrant, and a series
/// that ends too early.
TEST(Digits50, SinesAndCosinesAreBoosts) {
  constexpr unsigned kSeed = 11;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Numbers numbers(kSeed);
  const Boost half_turn = boost::math::constants::pi<Boost>();
  for (int i = 0; i < 5'000; ++i) {
    Boost angle = numbers.draw(i % 3 == 0 ? 30 : 3).boost;
    if (i % 5 == 0) {  // a double next to a quarter turn
      angle = static_cast<double>(Boost(half_turn / 2 * (i % 1000 - 500)));
    }
    const Digits50 own = Numbers::exactly(angle);
    const auto expect_near = [&](const Digits50& value, const Boost& expected) {
      const Digits50 error = value - Numbers::exactly(expected);
      // Boost's own reduction keeps 50 digits of the angle.
      const Digits50 allowed = Digits50(4e-50) * (1 + Numbers::exactly(Boost(abs(angle))));
      EXPECT_LE(abs(error), allowed) << text(angle);
    };
    expect_near(sin(own), sin(angle));
    expect_near(cos(own), cos(angle));
    EXPECT_LE(abs(sin(own) * sin(own) + cos(own) * cos(own) - 1), Digits50(1e-49)) << text(angle);
  }
}

/// Would catch: angles of many turns whose remainders lose digits.
TEST(Digits50, SineOfALargeAngleIsThatOfWhatIsLeft) {
  const Digits50 turns = 1e8;
  const Digits50 rest("1e-20");
  const Digits50 angle = 4 * turns * half_pi() + rest;
  // half_pi() is rounded: at most 2^-168 off, relatively.
  EXPECT_LE(abs(sin(angle) - rest), Digits50(1e-41));
  EXPECT_LE(abs(cos(angle) - 1), Digits50(1e-40));
}

TEST(Digits50, WhatIsNotFiniteStaysSo) {
  const Digits50 infinity = std::numeric_limits<Digits50>::infinity();
  EXPECT_TRUE(isinf(infinity + 1));
  EXPECT_TRUE(isinf(infinity * -2));
  EXPECT_TRUE(isnan(infinity - infinity));
  EXPECT_TRUE(isnan(infinity * 0));
  EXPECT_TRUE(isinf(std::numeric_limits<Digits50>::max() * 2));
  EXPECT_EQ(std::numeric_limits<Digits50>::min() * Digits50(1e-300), Digits50(0));
}

}  // namespace
}  // namespace treeline
