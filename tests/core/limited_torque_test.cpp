// Limits of torques and cones compared with the same program in other coordinates: a null space by
// singular values, costs as dense matrices. Would catch: a change where nothing is limited, torques
// beyond their limits, forces outside of cones that could be kept, motions that no motor or support
// can cause, a cost other than stated, dependent rows that are taken for independent ones, and a
// start from the last cycle that changes the answer.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "emitted_limits.h"
#include "random_support.hpp"

namespace {

using namespace treeline::core;         // NOLINT: the whole header is under test
using namespace treeline::core::tests;  // NOLINT

// NaN limits nothing, and no comparison says so. Would catch: `solved` beside it.
TEST(LimitedTorque, SaysThatALimitIsNoNumber) {
  using Sizes = LimitSizes<12, 3, 6, 4, 8, 9>;
  std::mt19937 engine(4);
  auto support = random_support<Sizes>(0, 4, 5, engine);
  ASSERT_EQ(run(support).limited.status, Limits<Sizes>::TL_SOLVED);
  support.limits.torque[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(run(support).limited.status, Limits<Sizes>::TL_NOT_CONVEX);
  support = random_support<Sizes>(0, 4, 5, engine);
  support.limits.cones[1].bound = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(run(support).limited.status, Limits<Sizes>::TL_NOT_CONVEX);
}

TEST(LimitedTorque, AFloatingBaseOnTwoFeet) {
  sweep<LimitSizes<12, 3, 6, 4, 8, 9>>(0, 4, 5);
}
TEST(LimitedTorque, TightCones) {
  sweep<LimitSizes<12, 3, 6, 4, 8, 9>>(0, 30, 0.5);
}
TEST(LimitedTorque, FeetOnOneLink) {
  sweep<LimitSizes<10, 3, 6, 2, 6, 10>>(3, 4, 5);
}
TEST(LimitedTorque, APointFootThatDoesNotCarryTheBase) {
  sweep<LimitSizes<9, 4, 2, 3, 2, 5>>(0, 4, 5);
}
TEST(LimitedTorque, AHandOnARail) {
  sweep<LimitSizes<7, 0, 3, 3, 3, 7>>(0, 4, 5);
}

TEST(LimitedTorque, WhatIsWithinLimitsIsNotTouched) {
  std::mt19937 engine(1);
  using Sizes = LimitSizes<12, 3, 6, 4, 8, 9>;
  for (int i = 0; i < 100; ++i) {
    const auto support = random_support<Sizes>(0, 100, 100, engine);
    const auto outcome = run(support);
    EXPECT_FALSE(outcome.limited.limited);
    EXPECT_EQ(outcome.tau, support.tau);
    EXPECT_EQ(outcome.f, support.f);
  }
}

TEST(LimitedTorque, ConesThatCannotBeKeptAreWidenedAlike) {
  std::mt19937 engine(2);
  using Sizes = LimitSizes<12, 3, 6, 4, 8, 9>;
  for (int i = 0; i < 100; ++i) {
    auto support = random_support<Sizes>(0, 4, 5, engine);
    // The first force at most -8, and at least 8.
    support.limits.cones[0] = {0, 1, {1}, -8};
    support.limits.cones[1] = {0, 1, {-1}, -8};
    const auto outcome = run(support);
    EXPECT_EQ(outcome.limited.status, Limits<Sizes>::TL_SOLVED);
    EXPECT_LE(outcome.tau.cwiseAbs().maxCoeff(), 4);
    EXPECT_GE(outcome.limited.slack, 8 - 1e-9);
    EXPECT_NEAR(most_beyond_cones(support, outcome.f), outcome.limited.slack, 1e-6);
  }
}

// Would catch: headers that are not C, and other bits in C than in C++.
TEST(LimitedTorque, IsTheSameInC) {
  using Sizes = LimitSizes<9, 3, 4, 3, 4, 7>;
  std::mt19937 engine(8);
  int limited = 0;
  for (int i = 0; i < 200; ++i) {
    const auto support = random_support<Sizes>(0, 4, 5, engine);
    const auto outcome = run(support);
    Outcome<Sizes> in_c{support.tau, support.f, {}};
    limit_torque_in_c(&support.layout, &support.limits, entries_of(support.M).data(),
                      entries_of(support.J_s).data(), entries_of(support.J_t).data(),
                      in_c.tau.data(), in_c.f.data(), &in_c.limited);
    EXPECT_EQ(in_c.tau, outcome.tau);
    EXPECT_EQ(in_c.f, outcome.f);
    EXPECT_EQ(in_c.limited.slack, outcome.limited.slack);
    EXPECT_EQ(in_c.limited.iterations, outcome.limited.iterations);
    limited += in_c.limited.limited ? 1 : 0;
  }
  EXPECT_GT(limited, 100);
}

// Would catch: a state that is taken from another one's column, or put there.
TEST(LimitedTorque, TakesAndPutsTheStatesOfABatch) {
  using L = Limits<LimitSizes<9, 3, 4, 3, 4, 7>, 4>;
  std::mt19937 engine(4);
  const Matrix given = random_matrix(4, 9, engine);  // in the memory of its columns: element i of
  Matrix put = Matrix::Zero(4, 9);                   // all states in a row
  for (int state = 0; state < 4; ++state) {
    Vector one(9);
    L::tl_take_state(given.data(), 9, state, one.data());
    EXPECT_EQ(one, given.row(state).transpose());
    L::tl_put_state(one.data(), 9, state, put.data());
  }
  EXPECT_EQ(put, given);
}

TEST(LimitedTorque, NoFiniteInputGivesNaN) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> decades(-300, 300);
  using Sizes = LimitSizes<9, 3, 4, 3, 4, 7>;
  for (int i = 0; i < 2000; ++i) {
    auto support = random_support<Sizes>(0, 4, 5, engine);
    const auto spoil = [&](auto& matrix) {
      for (double& each : matrix.reshaped()) {
        if (engine() % 30 == 0) each *= std::pow(10.0, decades(engine));
        if (engine() % 30 == 0) each = 0;
      }
    };
    spoil(support.M);
    spoil(support.J_s);
    spoil(support.J_t);
    spoil(support.tau);
    spoil(support.f);
    const auto outcome = run(support);
    EXPECT_TRUE(outcome.tau.allFinite());
    EXPECT_TRUE(outcome.f.allFinite());
    EXPECT_LE(outcome.tau.cwiseAbs().maxCoeff(), 4);
  }
}

}  // namespace
