// Limits of supports and tasks that come and go, compared with the same program in other
// coordinates. Would catch: rows and tasks that come and go by another law than stated, what is not
// held or done and leaves a trace, and torques that step while a share rises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "random_support.hpp"

namespace {

using namespace treeline::core;         // NOLINT: the whole header is under test
using namespace treeline::core::tests;  // NOLINT

TEST(LimitedShares, FeetAndTasksThatComeAndGo) {
  sweep<LimitSizes<12, 3, 6, 4, 8, 9>>(0, 4, 5, true);
}
TEST(LimitedShares, FeetThatComeAndGoInTightCones) {
  sweep<LimitSizes<12, 3, 6, 4, 8, 9>>(0, 30, 0.5, true);
}
TEST(LimitedShares, HandsThatComeAndGo) {
  sweep<LimitSizes<7, 0, 3, 3, 3, 7>>(0, 4, 5, true);
}

/// A support without the held rows from `Few::kHeld` on and the tasks from `Few::kTask` on.
template <class Few, class Sizes>
Support<Few> without_last(const Support<Sizes>& support) {
  Support<Few> few;
  few.M = support.M;
  few.J_s = support.J_s.topRows(Few::kHeld);
  few.J_t = support.J_t.topRows(Few::kTask);
  few.tau = support.tau;
  few.f = support.f.head(Few::kHeld);
  std::copy_n(support.layout.passive, Few::kPassive, few.layout.passive);
  std::copy_n(support.layout.force_weights, Few::kHeld, few.layout.force_weights);
  for (double& each : few.layout.shares) each = 1;
  for (double& each : few.layout.task_weights) each = 1;
  std::copy_n(support.limits.torque, Few::kVelocities, few.limits.torque);
  for (int c = 0; c < Few::kCones; ++c) {
    const auto& cone = support.limits.cones[c];
    few.limits.cones[c] = {
        cone.first, cone.count, {cone.coefficients[0], cone.coefficients[1]}, cone.bound};
  }
  for (double& each : few.limits.task_weights) each = 1;
  return few;
}

// Would catch: what is not held or done that leaves a trace, in the last bit.
TEST(LimitedShares, NoneOfARowHasTheBitsWithoutIt) {
  using Sizes = LimitSizes<12, 3, 6, 4, 8, 9>;
  using Few = LimitSizes<12, 3, 4, 3, 8, 9>;
  std::mt19937 engine(5);
  int limited = 0;
  for (int i = 0; i < 200; ++i) {
    auto support = random_support<Sizes>(0, 4, 5, engine);
    for (int c = 0; c < Sizes::kCones; ++c) support.limits.cones[c].first = c % 3;
    support.f.tail(2).setZero();
    const auto few = run(without_last<Few>(support));
    take_shares({1, 1, 0}, {1, 1, 1, 0}, support);
    const auto outcome = run(support);
    limited += outcome.limited.limited ? 1 : 0;
    EXPECT_EQ(outcome.tau, few.tau);
    EXPECT_EQ(Vector(outcome.f.head(4)), few.f);
    EXPECT_EQ(Vector(outcome.f.tail(2)), Vector(Vector::Zero(2)));
    EXPECT_EQ(outcome.limited.slack, few.limited.slack);
    EXPECT_EQ(outcome.limited.lost[3], 0);
  }
  EXPECT_GT(limited, 100);
}

double largest_change(const Vector& a, const Vector& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Torques while a foot is put down, one task begins and another one ends.
Vector torques_at(double share, const Support<LimitSizes<12, 3, 6, 4, 8, 9>>& support) {
  auto now = support;
  take_shares({1, 1, share}, {1, 1, share, 1 - share}, now);
  now.f.tail(2) *= share;
  return run(now).tau;
}

// Of an interval of shares the half in which torques change most, again and again. Would catch: a
// cone, a task or a row that has an effect as soon as its share is not 0, or another one at 1.
TEST(LimitedShares, NothingStepsWhileSharesRise) {
  using Sizes = LimitSizes<12, 3, 6, 4, 8, 9>;
  std::mt19937 engine(6);
  double worst = 0;
  for (int i = 0; i < 50; ++i) {
    SCOPED_TRACE(i);
    auto support = random_support<Sizes>(0, 4, 5, engine);
    for (auto& cone : support.limits.cones) cone.first -= cone.first % 2;
    for (int interval = 0; interval < 20; ++interval) {
      double first = interval / 20.0, last = (interval + 1) / 20.0;
      Vector from = torques_at(first, support), to = torques_at(last, support);
      for (int halving = 0; halving < 30; ++halving) {
        const double middle = (first + last) / 2;
        const Vector between = torques_at(middle, support);
        const bool before = largest_change(from, between) > largest_change(between, to);
        (before ? last : first) = middle;
        (before ? to : from) = between;
      }
      worst = std::max(worst, largest_change(from, to));
    }
  }
  std::printf("%g of 8 in a step of 5e-11\n", worst);
  EXPECT_LT(worst, 1e-4);
}

}  // namespace
