// Would catch: a step in position, velocity or acceleration at the begin of a motion, an end that
// is not the goal to the bit, derivatives that are not those of the position.
#include <gtest/gtest.h>

#include <cstdint>

namespace treeline::core {
namespace {

#define TL_INLINE static inline
#define TL_REAL(x) real(x)

/// Everything of runtime/emitted/quintic.h.
struct Emitted {
  using real = double;
  static constexpr real TL_ZERO = 0, TL_ONE = 1, TL_TEN = 10;
#include "emitted/quintic.h"
};

#undef TL_INLINE
#undef TL_REAL

struct Point {
  double x[2], v[2], a[2];
};

Point at(const double* coefficients, double duration, double time) {
  Point point{};
  const double left = Emitted::tl_share_left(time, 1 / duration);
  Emitted::tl_quintic_at(2, coefficients, left, 1 / duration, point.x, point.v, point.a);
  return point;
}

TEST(Quintic, LeavesInAnyStateAndArrivesAtRest) {
  const double x0[2] = {0.3, -1}, v0[2] = {2, -0.5}, a0[2] = {-7, 3}, x1[2] = {1.1, 0.7};
  constexpr double kDuration = 1.7;
  double c[8];
  Emitted::tl_quintic_to_rest(2, x0, v0, a0, x1, kDuration, c);
  const Point first = at(c, kDuration, 0), last = at(c, kDuration, kDuration),
              later = at(c, kDuration, 2 * kDuration);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(first.x[i], x0[i], 1e-14);
    EXPECT_NEAR(first.v[i], v0[i], 1e-13);
    EXPECT_NEAR(first.a[i], a0[i], 1e-13);
    EXPECT_EQ(last.x[i], x1[i]);
    EXPECT_EQ(later.x[i], x1[i]);
    EXPECT_EQ(last.v[i], 0);
    EXPECT_EQ(last.a[i], 0);
  }
}

TEST(Quintic, VelocityAndAccelerationAreDerivatives) {
  const double x0[2] = {0.3, -1}, v0[2] = {2, -0.5}, a0[2] = {-7, 3}, x1[2] = {1.1, 0.7};
  constexpr double kStep = 1e-5;  // differences are right to the square of it times the jerk's rate
  double c[8];
  Emitted::tl_quintic_to_rest(2, x0, v0, a0, x1, 1.7, c);
  for (double t = 0.1; t < 1.6; t += 0.1) {
    const Point before = at(c, 1.7, t - kStep), now = at(c, 1.7, t), after = at(c, 1.7, t + kStep);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR((after.x[i] - before.x[i]) / (2 * kStep), now.v[i], 1e-7);
      EXPECT_NEAR((after.v[i] - before.v[i]) / (2 * kStep), now.a[i], 1e-6);
    }
  }
}

TEST(Quintic, FromRestIsFastestAtFifteenEighthsOfTheMean) {
  const double x0[1] = {0}, none[1] = {0}, x1[1] = {2};
  double c[4];
  Emitted::tl_quintic_to_rest(1, x0, none, none, x1, 4.0, c);
  double x[1], v[1], a[1];
  Emitted::tl_quintic_at(1, c, 0.5, 0.25, x, v, a);
  EXPECT_NEAR(x[0], 1, 1e-15);
  EXPECT_NEAR(v[0], 15.0 / 8 * 2 / 4, 1e-15);
  EXPECT_NEAR(Emitted::tl_fade_out(0.5), 0.5, 1e-15);
  EXPECT_EQ(Emitted::tl_fade_out(1.0), 1);
  EXPECT_EQ(Emitted::tl_fade_out(0.0), 0);
}

}  // namespace
}  // namespace treeline::core
