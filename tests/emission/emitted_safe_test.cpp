#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/sin_cos.hpp"
#include "emission/same_bits.hpp"
#include "emission/sample.hpp"
#include "sample_safe_double/damped_solve.hpp"
#include "sample_safe_double/sample_safe_double.hpp"
#include "sample_safe_double/sin_cos.hpp"
#define _Bool bool  // what C calls it
#include "sample_safe_float/damped_solve.h"
#undef _Bool
#include "sample_safe_float/sample_safe_float.h"
#include "sample_safe_float/sin_cos.h"

// Would catch: a difference between the graph and the code of `profile: misra`: a value that one
// part of a function reads before another has written it, a constant under another's name, a sign
// or a swap of sines and cosines that are turned by tables.
namespace treeline {
namespace {

template <class Real, class Function>
void compare_long_chain(Function long_chain) {
  const Program program = test::trace_long_chain();
  std::mt19937 random(test::kSeed);
  for (int i = 0; i < test::kStates; ++i) {
    Real q[20];
    Real out[3];
    const std::vector<std::vector<Real>> arguments = {test::fill(q, random)};
    long_chain(q, out);
    test::expect_same_bits(out, evaluate(program, arguments)[0]);
  }
}

TEST(EmittedSafe, EqualsTheGraphToTheBit) {
  test::compare_two_link_arm<double>(sample_safe_double::inverse_dynamics);
  test::compare_two_link_arm<float>(sample_safe_float_inverse_dynamics);
  test::compare_corner_cases<double>(sample_safe_double::corner_cases);
  test::compare_corner_cases<float>(sample_safe_float_corner_cases);
  compare_long_chain<double>(sample_safe_double::long_chain);
  compare_long_chain<float>(sample_safe_float_long_chain);
}

/// Positive numbers of all magnitudes, with the least and the largest, and some that have no root.
template <class Real>
void compare_roots(Real (*root)(Real)) {
  using Limits = std::numeric_limits<Real>;
  std::vector<Real> numbers = {0,
                               Limits::denorm_min(),
                               2 * Limits::denorm_min(),
                               1,
                               2,
                               4,
                               8,
                               Limits::min(),
                               Limits::max(),
                               Limits::infinity()};
  std::mt19937_64 random(test::kSeed);
  std::uniform_real_distribution<Real> exponent(-Limits::digits - Limits::max_exponent,
                                                Limits::max_exponent);
  for (int i = 0; i < 200000; ++i) numbers.push_back(std::exp2(exponent(random)));
  for (const Real x : numbers) {
    ASSERT_EQ(root(x), std::sqrt(x)) << x;
  }
  EXPECT_EQ(root(-1), 0);
  EXPECT_EQ(root(Limits::quiet_NaN()), 0);
}

// Would catch: a power of four that is missing at either end, and a last bit.
TEST(EmittedSafe, RootsAreCorrectlyRounded) {
  compare_roots<double>(sample_safe_double::detail::root);
  compare_roots<float>([](float x) { return sample_safe_float_root(x); });
}

// Would catch: a rotation, a pivot or a rounding that is another than the runtime's.
TEST(EmittedSafe, DampedSolvesHaveTheBitsOfTheRuntime) {
  test::compare_damped_solves<double>(sample_safe_double::detail::damped_solve);
  test::compare_damped_solves<float>(sample_safe_float_damped_solve);
}

void sin_cos_of(double x, std::array<double, 2>& both) {
  sample_safe_double::detail::sin_cos(x, both[0], both[1]);
}
void sin_cos_of(float x, std::array<float, 2>& both) {
  sample_safe_float_sin_cos_of(x, &both[0], &both[1]);
}

template <class Real>
void compare_sin_cos(Real largest) {
  std::mt19937_64 random(test::kSeed);
  std::uniform_real_distribution<Real> exponent(std::log2(largest) - 40, std::log2(largest));
  std::vector<Real> angles = {0,
                              -Real{0},
                              largest,
                              -largest,
                              std::numeric_limits<Real>::min(),
                              std::numeric_limits<Real>::denorm_min()};
  for (int i = 0; i < 200000; ++i) {
    angles.push_back(std::exp2(exponent(random)) * (i % 2 == 0 ? 1 : -1));
  }
  for (int quarters = -2000; quarters <= 2000; ++quarters) {
    angles.push_back(static_cast<Real>(quarters * 1.5707963267948966));
  }
  for (const Real angle : angles) {
    std::array<Real, 2> expected;
    std::array<Real, 2> actual;
    core::sin_cos(angle, expected[0], expected[1]);
    sin_cos_of(angle, actual);
    ASSERT_EQ(std::memcmp(&actual, &expected, sizeof actual), 0) << angle;
  }
}

TEST(EmittedSafe, SinesAreThoseOfTheRuntimeWithinTheRange) {
  compare_sin_cos<double>(0x1p32);
  compare_sin_cos<float>(0x1p20F);
}

template <class Real>
void expect_no_angles(Real beyond) {
  constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  std::array<Real, 2> both;
  for (const Real angle : {beyond, -beyond, std::numeric_limits<Real>::max()}) {
    sin_cos_of(angle, both);
    EXPECT_EQ(both, (std::array<Real, 2>{0, 1})) << angle;
  }
  for (const Real angle : {kInfinity, -kInfinity, std::numeric_limits<Real>::quiet_NaN()}) {
    sin_cos_of(angle, both);
    EXPECT_TRUE(std::isnan(both[0]) && std::isnan(both[1])) << angle;
  }
}

TEST(EmittedSafe, WhatIsNoAngleIsZeroOrNaN) {
  expect_no_angles<double>(std::nextafter(0x1p32, 1e30));
  expect_no_angles<float>(std::nextafter(0x1p20F, 1e30F));
}

}  // namespace
}  // namespace treeline
