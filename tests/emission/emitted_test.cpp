#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "emission/same_bits.hpp"
#include "emission/sample.hpp"
#include "program/evaluate.hpp"
#include "sample_c_double.h"
#include "sample_c_double_batch.h"
#include "sample_c_double_joints.h"
#include "sample_c_float.h"
#include "sample_c_float_batch.h"
#include "sample_c_float_joints.h"
#include "sample_double.hpp"
#include "sample_double_batch.hpp"
#include "sample_double_calls.hpp"
#include "sample_double_eigen.hpp"
#include "sample_double_joints.hpp"
#include "sample_float.hpp"
#include "sample_float_batch.hpp"
#include "sample_float_eigen.hpp"
#include "sample_float_joints.hpp"

extern "C" {
double sample_c_double_call_portable_root(double x);
float sample_c_float_call_portable_root(float x);
double sample_c_double_call_damped_solve(const double* A, const double* mass_limits, double* x);
float sample_c_float_call_damped_solve(const float* A, const float* mass_limits, float* x);
}

// Would catch: any difference between the printed code, in C++ and in C, and the graph: an operand,
// a sign, a parenthesis, a digit, an index, the order of lanes. All folders in one program also
// detect names that clash.
namespace treeline {
namespace {

using test::compare_corner_cases;
using test::compare_damped_solves;
using test::compare_two_link_arm;
using test::expect_same_bits;
using test::fill;
using test::kSeed;
using test::kStates;

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

// In vectors, and in loops.
TEST(Emitted, BatchesInCEqualTheGraphToTheBit) {
  compare_batches<double>([](auto& q, auto& unread, auto& delta, auto& out, auto& second) {
    sample_c_double_batch_corner_cases(q[0], unread[0], delta[0], out[0], second[0]);
  });
  compare_batches<float>([](auto& q, auto& unread, auto& delta, auto& out, auto& second) {
    sample_c_float_batch_corner_cases(q[0], unread[0], delta[0], out[0], second[0]);
  });
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

// Would catch: a home outside of the limits, and an index of another joint.
TEST(Emitted, JointsAreFoundByName) {
  static_assert(sample_double::coordinate_index("shoulder") == 0);
  static_assert(sample_double::velocity_index("elbow") == 1);
  static_assert(sample_double::velocity_index("elb") == -1);
  static_assert(sample_double::velocity_index("elbows") == -1);
  static_assert(sample_double::coordinate_index("") == -1);
  static_assert(sample_float::kHome[0] == 0 && sample_float::kHome[1] == 0.25F);
  EXPECT_EQ(sample_c_float_home[1], 0.25F);
  EXPECT_STREQ(sample_c_double_velocity_joints[1], sample_double::kVelocityJoints[1]);
}

/// Results of the function itself, for comparison with other ways to call it.
struct CornerCases {
  double q[3] = {0.3, -1.2, 0.8};
  double delta[2] = {0.5, 1.5};
  double unread[2] = {4, 5};
  double out[12] = {};
  double second[1] = {};

  CornerCases() { sample_double::corner_cases(q, unread, delta, out, second); }

  /// Whether a matrix and a number are the function's results.
  template <class Out, class Second>
  void expect_same(const Out& other, const Second& other_second) const {
    for (Eigen::Index i = 0; i < 12; ++i) EXPECT_EQ(other(i / 3, i % 3), out[i]) << i;
    EXPECT_EQ(other_second[0], second[0]);
  }
};

// Would catch: an argument in another's place, and an output that is not written.
TEST(Emitted, NamedInputsCallTheSameFunction) {
  const CornerCases expected;
  sample_double::calls::CornerCasesInput in{};
  std::copy_n(expected.q, 3, in.q);
  std::copy_n(expected.delta, 2, in.delta);
  const sample_double::calls::CornerCasesOutput out = sample_double::calls::corner_cases(in);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(out.out[i], expected.out[i]) << i;
  EXPECT_EQ(out.second[0], expected.second[0]);
}

// Would catch: the same for std::array, std::vector and std::span.
TEST(Emitted, ArraysAndPointersCallTheSameFunction) {
  const CornerCases expected;
  const std::array<double, 3> q = {expected.q[0], expected.q[1], expected.q[2]};
  const std::array<double, 2> delta = {expected.delta[0], expected.delta[1]};
  std::array<double, 12> out{};
  std::array<double, 1> second{};
  sample_double::calls::corner_cases(q, delta, delta, out, second);
  EXPECT_TRUE(std::equal(out.begin(), out.end(), expected.out));
  EXPECT_EQ(second[0], expected.second[0]);

  const std::vector<double> q_vector(q.begin(), q.end());
  std::vector<double> out_vector(12);
  const std::span<const double> delta_span(delta);
  using sample_double::calls::array_at;
  sample_double::corner_cases(array_at<3>(q_vector.data()), expected.unread,
                              array_at<2>(delta_span.data()), array_at<12>(out_vector.data()),
                              array_at<1>(second.data()));
  EXPECT_TRUE(std::equal(out.begin(), out.end(), out_vector.begin()));
}

// Would catch: a matrix that comes out transposed, and elements of other places.
TEST(Emitted, EigenOfAnyKindCallsTheSameFunction) {
  const CornerCases expected;
  namespace eigen = sample_double::eigen;
  const Eigen::Vector3d fixed(0.3, -1.2, 0.8);
  const Eigen::VectorXd dynamic = fixed;
  const Eigen::Map<const Eigen::Vector2d> delta(expected.delta);
  Eigen::Matrix<double, 4, 3> by_columns;
  Eigen::Matrix<double, 4, 3, Eigen::RowMajor> by_rows;
  Eigen::Matrix<double, 1, 1> second;
  eigen::corner_cases(fixed, delta, delta, by_columns, second);
  expected.expect_same(by_columns, second);
  eigen::corner_cases(dynamic, delta, delta, by_rows, second);
  expected.expect_same(by_rows, second);

  Eigen::MatrixXd resized;
  Eigen::VectorXd second_resized;
  eigen::corner_cases(dynamic, delta, delta, resized, second_resized);
  ASSERT_EQ(resized.rows(), 4);
  ASSERT_EQ(resized.cols(), 3);
  ASSERT_EQ(second_resized.size(), 1);
  expected.expect_same(resized, second_resized);

  // Rows of a larger matrix, every second element of a vector, a sum, and a product.
  Eigen::MatrixXd large = Eigen::MatrixXd::Constant(6, 5, -7);
  Eigen::VectorXd every_second = Eigen::VectorXd::Constant(6, 9);
  Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<>> strided(every_second.data(), 3,
                                                               Eigen::InnerStride<>(2));
  strided = fixed;
  eigen::corner_cases(strided, delta * 1.0, Eigen::Matrix2d::Identity() * delta,
                      large.block(1, 2, 4, 3), second);
  expected.expect_same(large.block(1, 2, 4, 3), second);
  EXPECT_EQ((large.array() == -7).count(), 30 - 12);
  eigen::corner_cases(large.row(0).head(3) * 0 + fixed.transpose(), delta, delta, by_rows,
                      second_resized.head(1));
  expected.expect_same(by_rows, second_resized);
}

// Would catch: a copy where none is needed, which costs time and stack.
TEST(Emitted, EigenIsNotCopiedWhereItLiesInOrder) {
  using sample_double::eigen::detail::lies_in_order;
  static_assert(lies_in_order<Eigen::VectorXd>());
  static_assert(lies_in_order<Eigen::Matrix<double, 6, 1>>());
  static_assert(lies_in_order<Eigen::RowVectorXd>());
  static_assert(lies_in_order<Eigen::Map<const Eigen::VectorXd>>());
  static_assert(lies_in_order<Eigen::Ref<Eigen::VectorXd>>());
  static_assert(lies_in_order<Eigen::VectorBlock<Eigen::VectorXd, 3>>());
  static_assert(lies_in_order<Eigen::Block<Eigen::MatrixXd, Eigen::Dynamic, 1, true>>());
  static_assert(lies_in_order<Eigen::Matrix<double, 4, 3, Eigen::RowMajor>>());
  static_assert(lies_in_order<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>());
  static_assert(lies_in_order<Eigen::Map<Eigen::Matrix<double, 4, 3, Eigen::RowMajor>>>());
  static_assert(!lies_in_order<Eigen::Matrix<double, 4, 3>>());
  static_assert(!lies_in_order<Eigen::MatrixXd>());
  static_assert(!lies_in_order<Eigen::Block<Eigen::MatrixXd, 1, Eigen::Dynamic>>());
  static_assert(!lies_in_order<Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<>>>());
  static_assert(!lies_in_order<Eigen::Ref<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>>());
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
