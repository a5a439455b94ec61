// Limits of torque and friction of a humanoid with two feet and two hands, on generated code. Would
// catch: torques or forces beyond their limits, torques and forces that do not belong to the same
// motion, a law that differs from the unlimited one where no limit is reached, a start from the
// last cycle that changes the answer, and a program that is not solved within its iterations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "draw_humanoid.hpp"

namespace treeline::test {
namespace {

struct Answer {
  double tau[kRates], f[kHeldRows];
  humanoid::LimitedTorque limited = {};
};

void answer(const Asked& asked, Answer& answer,
            const humanoid::TorqueLimits& limits = humanoid::kTorqueLimits) {
  humanoid::limited_control_torque(asked.q, asked.qd, asked.qdd_0, asked.xdd_cmd, asked.f_wanted,
                                   answer.tau, answer.f, answer.limited, limits);
}

double most_beyond_cones(const double (&f)[kHeldRows]) {
  double most = 0;
  for (const auto& cone : humanoid::kTorqueLimits.cones) {
    double value = -cone.bound;
    for (int k = 0; k < cone.count; ++k) value += cone.coefficients[k] * f[cone.first + k];
    most = std::max(most, value);
  }
  return most;
}

/// How far M qdd + b + g = tau + J_s^T f is from holding for the motion that tau causes.
double equation_error(const Asked& asked, const Answer& answer) {
  constexpr double kNoStabilisation[2] = {};
  constexpr double kNoDrift[kHeldRows] = {};
  double qdd[kRates], acting[kHeldRows], forces[kRates], J[kHeldRows * kRates];
  humanoid::constrained_forward_dynamics(asked.q, asked.qd, answer.tau, kNoStabilisation, kNoDrift,
                                         qdd, acting);
  humanoid::inverse_dynamics(asked.q, asked.qd, qdd, forces);
  humanoid::constraint_jacobian(asked.q, J);
  double most = 0;
  for (int v = 0; v < kRates; ++v) {
    double error = forces[v] - answer.tau[v];
    for (int h = 0; h < kHeldRows; ++h) error -= J[h * kRates + v] * answer.f[h];
    most = std::max(most, std::fabs(error));
  }
  return most;
}

class Limits : public testing::TestWithParam<double> {};

TEST_P(Limits, AreKeptByForcesOfTheSameMotion) {
  std::mt19937_64 engine(1);
  Answer last;
  int limited = 0;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Asked asked = draw_humanoid(engine, GetParam());
    Answer cold;
    answer(asked, cold);
    EXPECT_EQ(cold.limited.status, humanoid::kSolved);
    limited += cold.limited.limited ? 1 : 0;
    for (int v = 0; v < 6; ++v) EXPECT_EQ(cold.tau[v], 0);
    for (int v = 6; v < kRates; ++v) {
      EXPECT_LE(std::fabs(cold.tau[v]), humanoid::kTorqueLimits.torque[v]);
    }
    // Of forces of 1e3 N, rounded with the condition of a program whose costs differ by 1e6.
    EXPECT_LE(most_beyond_cones(cold.f), cold.limited.slack + 1e-8);
    EXPECT_LT(equation_error(asked, cold), 1e-8);
    answer(asked, last);
    for (int v = 0; v < kRates; ++v) EXPECT_NEAR(last.tau[v], cold.tau[v], 1e-6);
  }
  std::printf("%d of 1000 limited\n", limited);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Limits, testing::Values(0.1, 1.0, 3.0));

TEST(LimitedHumanoid, WithinLimitsTheBitsAreThoseOfTheUnlimitedLaw) {
  std::mt19937_64 engine(2);
  humanoid::TorqueLimits wide = humanoid::kTorqueLimits;
  for (double& each : wide.torque) each = 1e9;
  for (auto& cone : wide.cones) cone.bound = 1e9;
  for (int i = 0; i < 100; ++i) {
    const Asked asked = draw_humanoid(engine, 1);
    Answer limited;
    answer(asked, limited, wide);
    double tau[kRates], f[kHeldRows];
    humanoid::supported_control_torque(asked.q, asked.qd, asked.qdd_0, asked.xdd_cmd,
                                       asked.f_wanted, tau, f);
    EXPECT_FALSE(limited.limited.limited);
    EXPECT_TRUE(std::equal(tau, tau + kRates, limited.tau));
    EXPECT_TRUE(std::equal(f, f + kHeldRows, limited.f));
  }
}

/// The task is given up last: where only internal forces must change, hands do not notice.
TEST(LimitedHumanoid, InternalForcesGiveWayFirst) {
  std::mt19937_64 engine(3);
  Asked asked = draw_humanoid(engine, 0);
  asked.f_wanted[2] = -200;  // the left foot pulls, beyond its cone
  asked.f_wanted[8] = 75 * 9.81 + 200;
  Answer limited;
  answer(asked, limited);
  EXPECT_TRUE(limited.limited.limited);
  EXPECT_EQ(limited.limited.slack, 0);
  for (const double lost : limited.limited.lost) EXPECT_NEAR(lost, 0, 1e-4);
}

}  // namespace
}  // namespace treeline::test
