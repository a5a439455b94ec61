// Limits of a quadruped that is asked for more than its motors have, so that feet lose their load.
// Would catch: rows that meet at the tip of a cone, five in three unknowns, and that roundings
// exchange until the iterations are used up; then forces were off by up to 7e5 N. So it was where a
// foot was about to be let go.
#include "four_feet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "four_feet_joints.hpp"
#include "four_feet_limited.hpp"

namespace treeline::test {
namespace {

constexpr int kCoordinates = 19, kRates = 18, kForces = 12, kRows = 6;

struct Asked {
  double q[kCoordinates], qd[kRates] = {}, qdd_0[kRates], xdd_cmd[kRows], f_wanted[kForces] = {};
  double active[4] = {1, 1, 1, 1};
};

/// The body tilted by up to 1.2 rad, legs within 0.6 rad of their zeros, accelerations of up to
/// some ten m/s^2.
Asked draw(std::mt19937& engine) {
  std::uniform_real_distribution<double> leg(-0.6, 0.6), tilt(0, 1.2);
  std::normal_distribution<double> normal;
  Asked asked;
  double axis[3], length = 0;
  for (double& x : axis) length += std::pow(x = normal(engine), 2);
  const double angle = tilt(engine), hardness[] = {1, 5, 15};
  std::fill(asked.q, asked.q + 3, 0.0);
  for (int i = 0; i < 3; ++i) asked.q[3 + i] = axis[i] / std::sqrt(length) * std::sin(angle / 2);
  asked.q[6] = std::cos(angle / 2);
  for (int i = 7; i < kCoordinates; ++i) asked.q[i] = leg(engine);
  for (double& qdd : asked.qdd_0) qdd = 5 * normal(engine);
  const double size = hardness[engine() % 3];
  for (double& xdd : asked.xdd_cmd) xdd = size * normal(engine);
  if (engine() % 2 == 0) {
    asked.active[engine() % 4] = std::uniform_real_distribution<double>(0.01, 0.05)(engine);
  }
  return asked;
}

class FourFeet : public testing::TestWithParam<double> {};

TEST_P(FourFeet, AreHeldByForcesWithinTheirCones) {
  constexpr unsigned kSeed = 1;
  std::mt19937 engine(kSeed);
  four_feet::TorqueLimits limits = four_feet::kTorqueLimits;
  for (int v = 6; v < kRates; ++v) limits.torque[v] *= GetParam();
  int unloaded = 0;
  for (int i = 0; i < 20000; ++i) {
    const Asked asked = draw(engine);
    double tau[kRates], f[kForces];
    four_feet::LimitedTorque limited{};
    four_feet::limited_control_torque(asked.q, asked.qd, asked.qdd_0, asked.xdd_cmd, asked.f_wanted,
                                      asked.active, tau, f, limited, limits);
    ASSERT_EQ(limited.status, four_feet::kSolved) << i;
    double largest = 1, beyond = 0;  // N
    for (const double force : f) largest = std::max(largest, std::fabs(force));
    for (const auto& cone : limits.cones) {
      if (asked.active[cone.first / 3] < 1) continue;  // whose cone is widened as it goes
      double value = -cone.bound;
      for (int k = 0; k < cone.count; ++k) value += cone.coefficients[k] * f[cone.first + k];
      beyond = std::max(beyond, value);
    }
    // A row that has left may be missed by 1e-9 of its terms, which are some forces.
    EXPECT_LE(beyond, limited.slack + 1e-8 * largest) << i;
    for (int foot = 0; foot < 4; ++foot) unloaded += std::fabs(f[3 * foot + 2]) < 1e-9 ? 1 : 0;
  }
  EXPECT_GT(unloaded, 1000);
}

// Shares of the motors' torques.
INSTANTIATE_TEST_SUITE_P(Torques, FourFeet, testing::Values(0.1, 0.2, 0.3, 0.4));

}  // namespace
}  // namespace treeline::test
