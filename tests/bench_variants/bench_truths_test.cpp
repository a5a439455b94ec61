#include "bench/bench_truths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "check/fixture.hpp"

// Which states variants are measured at. Would catch quaternions that all have unit length, or none
// of which has, peers that are asked about those of another length, numbers that float cannot hold.

namespace treeline::tests {
namespace {

/// Of no function: the states are what is looked at.
BenchTruths truths_of(const std::string& name, int states) {
  const Subjects subjects = load(name);
  BenchOptions options;
  options.states = states;
  return {subjects.robot, subjects.scene, {}, options};
}

/// Of the base, with whose position and quaternion q begins.
double length_error(const State& state) {
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) square += state.q[i] * state.q[i];
  return std::abs(std::sqrt(square) - 1);
}

/// How many have unit length as well as double has it, and as well as float at best.
std::pair<int, int> count_lengths(const std::vector<StateReference>& references) {
  std::pair<int, int> counts;
  for (const StateReference& reference : references) {
    const double error = length_error(reference.state);
    EXPECT_LT(error, 2e-7);  // float's rounding of four numbers
    ++(error < 1e-15 ? counts.first : counts.second);
  }
  return counts;
}

TEST(BenchTruths, HaveQuaternionsOfUnitLengthAndOthers) {
  const BenchTruths truths = truths_of("tumbler", 24);
  const Variant in_double{Function::gravity, VariantGroup::emitted, "double", Real::float64};
  const Variant in_float{Function::gravity, VariantGroup::real, "float", Real::float32};
  const Variant peer{Function::gravity, VariantGroup::peer, "peer", Real::float64};
  const auto [unit, rounded] = count_lengths(truths.of(in_double));
  EXPECT_EQ(unit + rounded, 24);
  EXPECT_GE(unit, 8);
  EXPECT_GE(rounded, 6);
  EXPECT_EQ(count_lengths(truths.of(peer)), std::pair(unit, 0));
  EXPECT_EQ(truths.of(in_float).size(), 24U);
  for (const StateReference& reference : truths.of(in_float)) {
    for (const double x : reference.state.q)
      EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
  }
}

TEST(BenchTruths, AreTheSameForAllWithoutAQuaternion) {
  const BenchTruths truths = truths_of("planar3r", 4);
  EXPECT_FALSE(truths.has_quaternions());
  const Variant peer{Function::gravity, VariantGroup::peer, "peer", Real::float64};
  EXPECT_EQ(&truths.of(peer), &truths.in_float());
}

}  // namespace
}  // namespace treeline::tests
