// Would catch: a wrong term of the angular velocity or acceleration of a turning rotation vector, a
// series that ends too early.
#include <gtest/gtest.h>

#include <cmath>

#include "core/orientation.hpp"

namespace treeline::core {
namespace {

using Turning = EmittedOrientation<double>;

/// A rotation vector that moves, up to 3.2 rad long.
void vector_at(double t, double (&r)[3], double (&rd)[3], double (&rdd)[3]) {
  const double a[3] = {0.4, -1.3, 0.9}, b[3] = {1.1, 0.2, -1.6}, c[3] = {-0.3, 0.8, 0.5};
  for (int i = 0; i < 3; ++i) {
    r[i] = a[i] + t * (b[i] + t * c[i]);
    rd[i] = b[i] + 2 * t * c[i];
    rdd[i] = 2 * c[i];
  }
}

struct Rates {
  double R[9], w[3], wd[3];
};

Rates rates_at(double t) {
  double r[3], rd[3], rdd[3];
  vector_at(t, r, rd, rdd);
  Rates rates{};
  Turning::tl_turn_rates(r, rd, rdd, rates.w, rates.wd);
  rotation_from_vector(r, rates.R);
  return rates;
}

TEST(TurnMotion, AngularVelocityIsThatOfTheRotation) {
  constexpr double kStep = 1e-6;
  for (double t = -0.8; t < 1; t += 0.1) {
    const Rates before = rates_at(t - kStep), now = rates_at(t), after = rates_at(t + kStep);
    double turned[3];
    orientation_error(before.R, after.R, turned);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(turned[i] / (2 * kStep), now.w[i], 1e-8) << t;
      EXPECT_NEAR((after.w[i] - before.w[i]) / (2 * kStep), now.wd[i], 1e-8) << t;
    }
  }
}

TEST(TurnMotion, AlongOneAxisItIsTheVectorsOwn) {
  const double r[3] = {1.2, -0.6, 0.3}, rd[3] = {2.4, -1.2, 0.6}, rdd[3] = {-1.2, 0.6, -0.3};
  double w[3], wd[3];
  Turning::tl_turn_rates(r, rd, rdd, w, wd);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(w[i], rd[i], 1e-15);
    EXPECT_NEAR(wd[i], rdd[i], 1e-15);
  }
}

TEST(TurnMotion, SeriesAreThoseOfSineAndCosine) {
  for (const double t : {0.0, 1e-3, 0.5, 2.0, 3.4}) {
    double B = 0, C = 0, dB = 0, dC = 0;
    Turning::tl_alternating_series(t * t, 2, &B, &dB);
    Turning::tl_alternating_series(t * t, 3, &C, &dC);
    if (t > 0.1) {
      EXPECT_NEAR(B, (1 - std::cos(t)) / (t * t), 1e-14);
      EXPECT_NEAR(C, (t - std::sin(t)) / (t * t * t), 1e-14);
    } else {
      EXPECT_NEAR(B, 0.5, t * t);
      EXPECT_NEAR(C, 1.0 / 6, t * t);
    }
    float b = 0, db = 0;
    EmittedOrientation<float>::tl_alternating_series(static_cast<float>(t * t), 2, &b, &db);
    EXPECT_NEAR(static_cast<double>(b), B, 2e-6);
  }
}

}  // namespace
}  // namespace treeline::core
