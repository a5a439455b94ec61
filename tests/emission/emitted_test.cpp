#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "core/damped_solve.hpp"
#include "emission/sample.hpp"
#include "program/evaluate.hpp"
#include "sample_c_double.h"
#include "sample_c_double_joints.h"
#include "sample_c_float.h"
#include "sample_c_float_joints.h"
#include "sample_double_batch.hpp"
#include "sample_double_eigen.hpp"
#include "sample_double_joints.hpp"
#include "sample_float_batch.hpp"
#include "sample_float_eigen.hpp"
#include "sample_float_joints.hpp"

extern "C" {
double sample_c_double_call_portable_root(double x);
float sample_c_float_call_portable_root(float x);
double sample_c_double_call_damped_solve(const double* A, const double* heaviest, double* x);
float sample_c_float_call_damped_solve(const float* A, const float* heaviest, float* x);
}

// Would catch: any difference between the printed code, in C++ and in C, and the graph: an operand,
// a sign, a parenthesis, a digit, an index, the order of lanes. All folders in one program also
// detect names that clash.
namespace treeline {
namespace {

template <class Real, std::size_t size>
void expect_same_bits(const Real (&actual)[size], const std::vector<Real>& expected) {
  ASSERT_EQ(size, expected.size());
  for (std::size_t i = 0; i < size; ++i) {
    EXPECT_EQ(std::memcmp(&actual[i], &expected[i], sizeof(Real)), 0)
        << i << ": " << actual[i] << " instead of " << expected[i];
  }
}

template <class Real, std::size_t size>
std::vector<Real> fill(Real (&array)[size], std::mt19937& random) {
  std::uniform_real_distribution<Real> uniform(-4, 4);
  for (Real& element : array) {
    element = uniform(random);
  }
  return {array, array + size};
}

constexpr int kStates = 200;
constexpr unsigned kSeed = 11;

template <class Real, class Function>
void compare_two_link_arm(Function inverse_dynamics) {
  const Program program = test::sample_programs()[0];
  std::mt19937 random(kSeed);
  for (int i = 0; i < kStates; ++i) {
    Real q[2];
    Real qd[2];
    Real qdd[2];
    Real tau[2];
    const std::vector<std::vector<Real>> arguments = {fill(q, random), fill(qd, random),
                                                      fill(qdd, random)};
    inverse_dynamics(q, qd, qdd, tau);
    expect_same_bits(tau, evaluate(program, arguments)[0]);
  }
}

template <class Real, class Function>
void compare_corner_cases(Function corner_cases) {
  const Program program = test::sample_programs()[1];
  std::mt19937 random(kSeed);
  for (int i = 0; i < kStates; ++i) {
    Real q[3];
    Real unread[2];
    Real delta[2];
    Real out[12];
    Real second[1];
    const std::vector<std::vector<Real>> arguments = {fill(q, random), fill(unread, random),
                                                      fill(delta, random)};
    corner_cases(q, unread, delta, out, second);
    const auto results = evaluate(program, arguments);
    expect_same_bits(out, results[0]);
    expect_same_bits(second, results[1]);
  }
}

template <class Real, int size, int states>
std::vector<Real> fill_rows(Real (&rows)[size][states], int state, std::mt19937& random) {
  Real one[size];
  std::vector<Real> filled = fill(one, random);
  for (int i = 0; i < size; ++i) rows[i][state] = one[i];
  return filled;
}

template <class Real, int size, int states>
void expect_column(const Real (&rows)[size][states], int state, const std::vector<Real>& expected) {
  Real one[size];
  for (int i = 0; i < size; ++i) one[i] = rows[i][state];
  expect_same_bits(one, expected);
}

// Would catch in addition: a state that is computed from the numbers of another one.
template <class Real, class Function>
void compare_batches(Function corner_cases) {
  const Program program = test::sample_programs()[1];
  constexpr int kBatch = test::kSampleBatch;
  std::mt19937 random(kSeed);
  for (int i = 0; i < kStates; ++i) {
    Real q[3][kBatch];
    Real unread[2][kBatch];
    Real delta[2][kBatch];
    Real out[12][kBatch];
    Real second[1][kBatch];
    std::vector<std::vector<std::vector<Real>>> arguments;
    for (int state = 0; state < kBatch; ++state) {
      arguments.push_back({fill_rows(q, state, random), fill_rows(unread, state, random),
                           fill_rows(delta, state, random)});
    }
    corner_cases(q, unread, delta, out, second);
    for (int state = 0; state < kBatch; ++state) {
      const auto results = evaluate(program, arguments[static_cast<std::size_t>(state)]);
      expect_column(out, state, results[0]);
      expect_column(second, state, results[1]);
    }
  }
}

TEST(Emitted, BatchesEqualTheGraphToTheBit) {
  compare_batches<double>(sample_double::batch::corner_cases);
  compare_batches<float>(sample_float::batch::corner_cases);
}

TEST(Emitted, TwoLinkArmEqualsTheGraphToTheBit) {
  compare_two_link_arm<double>(sample_double::inverse_dynamics);
  compare_two_link_arm<float>(sample_float::inverse_dynamics);
  compare_two_link_arm<double>(sample_c_double_inverse_dynamics);
  compare_two_link_arm<float>(sample_c_float_inverse_dynamics);
}

TEST(Emitted, CornerCasesEqualTheGraphToTheBit) {
  compare_corner_cases<double>(sample_double::corner_cases);
  compare_corner_cases<float>(sample_float::corner_cases);
  compare_corner_cases<double>(sample_c_double_corner_cases);
  compare_corner_cases<float>(sample_c_float_corner_cases);
}

/// The root of every number of these bits; of a NaN only that it is one.
template <class Real, class Bits, class Function>
void compare_roots(Function root, const std::vector<Bits>& all) {
  for (const Bits bits : all) {
    Real x;
    std::memcpy(&x, &bits, sizeof x);
    const Real expected = std::sqrt(x);
    const Real actual = root(x);
    ASSERT_TRUE(std::isnan(expected) ? std::isnan(actual)
                                     : std::memcmp(&expected, &actual, sizeof x) == 0)
        << x << ": " << actual << " instead of " << expected;
  }
}

// Would catch: a bit of the exponent or the last rounding, zeros, subnormal numbers and infinities
// of the square root in C that targets without an instruction use.
TEST(Emitted, PortableRootsInCAreCorrectlyRounded) {
  std::mt19937_64 random(kSeed);
  std::vector<std::uint64_t> doubles = {0,
                                        1,
                                        2,
                                        3,
                                        std::uint64_t{1} << 63,
                                        std::uint64_t{2047} << 52,
                                        std::uint64_t{4095} << 52,
                                        (std::uint64_t{1} << 52) - 1};
  std::vector<std::uint32_t> floats = {0,        1,          2,          3,
                                       1U << 31, 255U << 23, 511U << 23, (1U << 23) - 1};
  for (int i = 0; i < 300000; ++i) {
    doubles.push_back(random() >> (i % 4 == 0 ? i % 60 : 1));
    floats.push_back(static_cast<std::uint32_t>(random() >> (i % 4 == 0 ? 33 + i % 30 : 32)));
  }
  compare_roots<double>(sample_c_double_call_portable_root, doubles);
  compare_roots<float>(sample_c_float_call_portable_root, floats);
}

/// Tasks of two rows from well moved to singular, where one row or both yield.
template <class Real, class Function>
void compare_damped_solves(Function solve) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<Real> uniform(-4, 4);
  for (int i = 0; i < 20000; ++i) {
    const Real a = uniform(random), b = uniform(random), c = i % 3 == 0 ? 0 : uniform(random);
    const Real A[4] = {a * a, a * b, a * b, b * b + c * c};
    const Real heaviest[2] = {Real(0.1) + a * a, 3};
    Real expected[2] = {uniform(random), uniform(random)};
    Real actual[2] = {expected[0], expected[1]};
    const Real ease = core::damped_solve(A, heaviest, expected);
    const Real ease_in_c = solve(A, heaviest, actual);
    ASSERT_EQ(std::memcmp(&ease, &ease_in_c, sizeof ease), 0) << i;
    ASSERT_EQ(std::memcmp(expected, actual, sizeof actual), 0) << i;
  }
}

// Would catch: a rotation, a pivot or a rounding in C that is another than the runtime's.
TEST(Emitted, DampedSolveInCHasTheBitsOfTheRuntime) {
  compare_damped_solves<double>(sample_c_double_call_damped_solve);
  compare_damped_solves<float>(sample_c_float_call_damped_solve);
}

// Would catch: a name that ends its string, a limit that is missing, and names in another order.
TEST(Emitted, JointsAreConstants) {
  static_assert(sample_double::kLowerLimits[0] == -3.1);
  static_assert(sample_double::kUpperLimits[1] == std::numeric_limits<double>::max());
  static_assert(sample_float::kVelocityLimits[0] == 3);
  static_assert(sample_float::kEffortLimits[1] == std::numeric_limits<float>::max());
  EXPECT_STREQ(sample_double::kCoordinateJoints[1], "elbow \\ \"2\"");
  EXPECT_STREQ(sample_double::kCoordinateMeanings[0], "angle, rad");
  EXPECT_STREQ(sample_float::kVelocityNames[1], "elbow, rad/s");
  EXPECT_STREQ(sample_float::kTaskRowNames[1], "tool y");
}

TEST(Emitted, JointsInCAreThoseInCpp) {
  static_assert(SAMPLE_C_DOUBLE_VELOCITIES == sample_double::kVelocities);
  static_assert(SAMPLE_C_DOUBLE_TASK_ROWS == sample_double::kTaskRows);
  EXPECT_EQ(sample_c_double_lower_limits[0], sample_double::kLowerLimits[0]);
  EXPECT_EQ(sample_c_double_upper_limits[1], sample_double::kUpperLimits[1]);
  EXPECT_EQ(sample_c_float_velocity_limits[0], sample_float::kVelocityLimits[0]);
  EXPECT_EQ(sample_c_float_effort_limits[1], sample_float::kEffortLimits[1]);
  EXPECT_STREQ(sample_c_double_coordinate_joints[1], sample_double::kCoordinateJoints[1]);
  EXPECT_STREQ(sample_c_double_coordinate_meanings[0], sample_double::kCoordinateMeanings[0]);
  EXPECT_STREQ(sample_c_float_velocity_names[1], sample_float::kVelocityNames[1]);
  EXPECT_STREQ(sample_c_float_task_row_names[1], sample_float::kTaskRowNames[1]);
}

TEST(Emitted, EigenWrapperCallsTheSameFunction) {
  const sample_double::eigen::Vector<3> q(0.3, -1.2, 0.8);
  const sample_double::eigen::Vector<2> delta(0.5, 1.5);
  sample_double::eigen::Matrix<4, 3> out;
  sample_double::eigen::Vector<1> second;
  sample_double::eigen::corner_cases(q, delta, delta, out, second);
  EXPECT_EQ(out(0, 1), -2.5);
  EXPECT_EQ(out(1, 1), q[1]);
  EXPECT_EQ(out(1, 0), q[0] * delta[1]);
}

}  // namespace
}  // namespace treeline
