// Square roots compared with libm's, which are correctly rounded, to the bit: by the target's
// instruction, and bit by bit without it. Would catch: a wrong last bit, a lost subnormal number,
// zero without its sign, and a root of a number that has none.
#include "core/square_root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace treeline::core;  // NOLINT: the whole header is under test

template <class Real>
bool is_same(Real a, Real b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof(Real)) == 0;
}

template <class Real>
void expect_root(Real x) {
  EXPECT_TRUE(is_same(square_root(x), std::sqrt(x))) << x;
  EXPECT_TRUE(is_same(EmittedSquareRoot<Real>::tl_portable_square_root(x), std::sqrt(x))) << x;
}

template <class Real>
void expect_special_roots() {
  using Limits = std::numeric_limits<Real>;
  for (const Real x : {Real(0), Real(1), Real(2), Real(4), Limits::min(), Limits::denorm_min(),
                       Limits::max(), Limits::infinity(), Limits::quiet_NaN()}) {
    expect_root(x);
    expect_root(-x);
    for (const Real beside : {std::nextafter(x, Real(0)), std::nextafter(x, Limits::max())}) {
      expect_root(beside);
    }
  }
}

TEST(SquareRoot, OfSpecialNumbers) {
  expect_special_roots<float>();
  expect_special_roots<double>();
}

// Every 4099th float with both signs, including subnormal numbers and NaN.
TEST(SquareRoot, OfFloats) {
  for (std::uint64_t bits = 0; bits <= 0xffffffffU; bits += 4099) {
    const auto narrow = static_cast<std::uint32_t>(bits);
    float x = 0;
    std::memcpy(&x, &narrow, sizeof(x));
    ASSERT_NO_FATAL_FAILURE(expect_root(x));
  }
}

// Doubles with random bits, and squares and their neighbours, where rounding is most difficult.
TEST(SquareRoot, OfDoubles) {
  constexpr std::uint64_t kSeed = 3;
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t bits = random() >> (i % 4 == 0 ? i % 64 : 0);
    double x = 0;
    std::memcpy(&x, &bits, sizeof(x));
    expect_root(x);
    const double root = static_cast<double>(random() >> 38);
    for (const double square : {root * root, std::nextafter(root * root, 0.0)}) expect_root(square);
    ASSERT_FALSE(HasFailure()) << "seed " << kSeed;
  }
}

}  // namespace
