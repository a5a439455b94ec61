#include "recursion/algebra/pivot_rule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recursion/methods/ordinary_states.hpp"
#include "recursion/methods/resolved_by_pivots.hpp"

// Relaxed pivots, elimination by given pivots, and rotations of quaternions of any length. Would
// catch: a pole near zero, an inverse that is inaccurate for ordinary pivots, a jump, an unknown in
// the wrong place, a row that only rounding moves, and a quaternion that scales or gives NaN.

namespace treeline::tests {
namespace {

constexpr int kPowers[] = {4, 6, 8};

TEST(BoundedInverse, IsOneOverCFarAboveTheBorder) {
  for (const int power : kPowers) {
    const double far = std::pow(2.0, 54.0 / power);
    for (const double c : {far, 3 * far, 1e3 * far}) {
      EXPECT_NEAR(bounded_inverse(c * 0.25, 0.25, power) * (c * 0.25), 1, 4e-16) << power;
    }
  }
}

TEST(BoundedInverse, IsBoundedAndVanishesNextToZeroOnBothSides) {
  for (const int power : kPowers) {
    double largest = 0;
    for (double t = -4; t <= 4; t += 1.0 / 1024) {
      const double g = bounded_inverse(t * 1e-6, 1e-6, power);
      ASSERT_TRUE(std::isfinite(g));
      EXPECT_EQ(std::signbit(g) && g != 0, t < 0);
      largest = std::max(largest, g * 1e-6);
    }
    EXPECT_GT(largest, 0.56);
    EXPECT_LT(largest, 0.69);
    EXPECT_EQ(bounded_inverse(0.0, 1e-6, power), 0);
    for (const double noise : {1e-17, -1e-17}) {
      EXPECT_LT(std::abs(bounded_inverse(noise, 1e-6, power)), 1e-20) << power;
    }
  }
}

TEST(BoundedInverse, OfFloatStaysInItsRange) {
  const BoundedInverseShape shape = inverse_inertia_shape(Real::float32);
  for (const double ordinary : {1e-4, 1.0, 1e4, 1e8, 1e16}) {
    for (const double of_it : {0.0, 1e-9, 1e-3, 1.0, 4.0, 1e3}) {
      const auto c = static_cast<float>(ordinary * of_it);
      const float g = bounded_inverse(c, ordinary * shape.share, shape.power);
      EXPECT_TRUE(std::isfinite(g)) << ordinary << " " << of_it;
      if (of_it < 0.1) continue;
      EXPECT_NEAR(static_cast<double>(g * c), 1, 1e-6) << ordinary;
    }
  }
}

/// The most that joints move for a motion of the task of size 1, where pivots of ordinary states
/// are 1: 1/c for a Jacobian, 1/sqrt(c) for an inverse inertia, of what is followed.
double most_of_joints(const BoundedInverseShape& shape, double power_of_c) {
  double most = 0;
  for (double c = 1; c > 1e-9; c *= 0.99) {
    most = std::max(most, std::pow(c, power_of_c) * bounded_inverse(c, shape.share, shape.power));
  }
  return most;
}

// Would catch: an early law that asks joints for as much as `smooth`, hundreds of times an ordinary
// speed, and a float's that yields later than a double's.
TEST(BoundedInverse, EarlyAsksJointsForLess) {
  constexpr auto kEarly = SingularTasks::early;
  for (const Real real : {Real::float32, Real::float64}) {
    EXPECT_LT(most_of_joints(inverse_inertia_shape(real, kEarly), 0.5), 70);
    EXPECT_LT(most_of_joints(jacobian_shape(real, kEarly), 0), 90);
  }
  EXPECT_GT(most_of_joints(inverse_inertia_shape(Real::float64), 0.5), 200);
  EXPECT_GT(most_of_joints(jacobian_shape(Real::float64), 0), 600);
}

// Rounded products of rotations move the second row by 3e-17 where others move by 1. Would catch an
// inverse of 1e33 for it, and a border that takes in the third row, which is moved by 4e-6.
TEST(OrdinaryPivots, LetRowsYieldThatRoundingMoves) {
  OrdinaryPivots pivots;
  DenseMatrix<double> A(3, 3);
  A(0, 0) = 2;
  A(1, 1) = 1e-33;
  A(2, 2) = 1.6e-11;
  for (int state = 0; state < kOrdinaryStates; ++state) pivots.add(A);
  const BoundedInverseShape shape = inverse_inertia_shape(Real::float64);
  const auto borders = pivots.borders(shape);
  EXPECT_LT(bounded_inverse(A(1, 1), borders[1], shape.power), 1e-30);
  EXPECT_NEAR(bounded_inverse(A(2, 2), borders[2], shape.power) * A(2, 2), 1, 1e-15);
}

// A row that no joint moves has the pivot 0. Would catch 0 / 0.
TEST(BoundedInverse, OfZeroIsZeroAtTheLeastBorder) {
  for (const BoundedInverseShape& shape :
       {inverse_inertia_shape(Real::float32), jacobian_shape(Real::float32)}) {
    EXPECT_EQ(bounded_inverse(0.0F, shape.least, shape.power), 0);
    EXPECT_GE(std::pow(shape.least, shape.power), std::numeric_limits<float>::min());
  }
  for (const BoundedInverseShape& shape :
       {inverse_inertia_shape(Real::float64), jacobian_shape(Real::float64)}) {
    EXPECT_EQ(bounded_inverse(0.0, shape.least, shape.power), 0);
    EXPECT_GE(std::pow(shape.least, shape.power), std::numeric_limits<double>::min());
  }
}

TEST(PivotRule, WithoutBordersInvertsAsItIs) {
  EXPECT_EQ(PivotRule{}(3, 4.0), 0.25);
  EXPECT_EQ((PivotRule{6, {0, 1e-3}}(0, 4.0)), 0.25);
  EXPECT_EQ((PivotRule{6, {0, 1e-3}}(1, 0.0)), 0);
}

TEST(Eliminate, SolvesInEveryOrderOfPivots) {
  DenseMatrix<double> A(3, 3);
  const double entries[9] = {2, 1, 0, 0, 3, 1, 1, 0, 4};
  for (std::size_t i = 0; i < 9; ++i) A(i / 3, i % 3) = entries[i];
  const double x[3] = {0.5, -2, 3};
  std::vector<double> v(3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) v[i] += A(i, j) * x[j];
  }
  const std::vector<std::vector<Pivot>> orders{
      {{0, 0}, {1, 1}, {2, 2}}, {{2, 2}, {0, 1}, {1, 0}}, {{1, 2}, {2, 0}, {0, 1}}};
  for (const auto& order : orders) {
    const auto solved = eliminate(A, v, order, PivotRule{});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(solved[i], x[i], 1e-14);
  }
}

/// An unknown with an equation of its own is relaxed alone; the other equations use its relaxed
/// value.
TEST(Eliminate, LetsAnUnknownYieldAlone) {
  DenseMatrix<double> A(2, 2);
  A(0, 0) = 0;
  A(1, 0) = 5;
  A(1, 1) = 2;
  const auto x = eliminate<double>(A, {1, 8}, {{0, 0}, {1, 1}}, PivotRule{6, {1e-3, 0}});
  EXPECT_EQ(x[0], 0);
  EXPECT_EQ(x[1], 4);
}

TEST(Quaternion, TurnsByItsDirectionWhateverItsLength) {
  const double q[4] = {0.1, -0.7, 0.3, 0.64};
  const auto R = rotation_from_quaternion(q[0], q[1], q[2], q[3]);
  for (const double length : {1e-6, 0.5, 1 + 6e-8, 1e3}) {
    const auto S =
        rotation_from_quaternion(length * q[0], length * q[1], length * q[2], length * q[3]);
    EXPECT_NEAR(S.row_x.x, R.row_x.x, 1e-15) << length;
    EXPECT_NEAR(S.row_y.z, R.row_y.z, 1e-15) << length;
  }
  EXPECT_NEAR(dot(R.row_x, R.row_x), 1, 4e-16);
  EXPECT_NEAR(dot(R.row_x, R.row_y), 0, 4e-16);
}

TEST(Quaternion, OfNothingTurnsByNothing) {
  for (const double tiny : {0.0, 1e-200, -1e-320}) {
    const auto R = rotation_from_quaternion(tiny, 0.0, tiny, 0.0);
    EXPECT_EQ(R.row_x.x, 1);
    EXPECT_TRUE(std::abs(R.row_y.z) < 1e-300);
  }
  const auto F = rotation_from_quaternion(0.0F, 0.0F, 0.0F, 0.0F);
  EXPECT_EQ(F.row_z.z, 1.0F);
}

}  // namespace
}  // namespace treeline::tests
