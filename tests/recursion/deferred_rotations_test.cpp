#include "recursion/tree/deferred_rotations.hpp"

#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "recursion/template_results.hpp"

// The axes in which links are treated do not change results: every recursion, with the rotation of
// any links deferred and any columns carried, for robots with many parallel axes, compared with the
// interpreter in 50 digits. Would catch: a constant that was not rotated, a rotation that is
// applied twice, late or with the wrong sign behind flipped and prismatic joints, and angular
// accelerations that are not adapted.

namespace treeline::tests {
namespace {

constexpr double kTolerance = 1e-41;  // nothing is rounded above 1e-50

Mechanism with_random_choices(Mechanism mechanism, Rng& rng) {
  for (MovingLink& link : mechanism.links) {
    if (link.kind == JointKind::floating) continue;
    link.defers_rotation = rng.unit() < 0.6;
    link.carries_column = rng.unit() < 0.5;
  }
  return mechanism;
}

/// All that `TemplateRun` knows.
constexpr bool is_recursion(const FunctionInfo& row) {
  return is_nameable(row) && is_about<FunctionGroup::robot, FunctionGroup::points>(row);
}
constexpr auto kRecursions = select_functions<is_recursion>();

void expect_same_motion(const RandomMechanism& made, std::uint64_t seed) {
  Rng rng(seed);
  const Oracle<Digits50> oracle(made.robot, made.scene);
  const Inputs<Digits50> in = oracle.random_inputs(rng, 5);
  const Yardstick size = yardstick(oracle, in);
  const TemplateRun<Digits50> run(
      with_random_choices(reduced_mechanism(made.robot, made.scene), rng), in);
  for (const Function function : kRecursions) {
    if (!permits(function, oracle.has_points(), size)) continue;
    const auto expected = oracle.results(function, in);
    for (const auto& [route, results] : run.results(function)) {
      EXPECT_LE(
          relative_error(results, expected, size.least_scale(function)) / size.growth(function),
          kTolerance)
          << function_name(function) << " " << route;
    }
  }
}

TEST(DeferredRotations, ChangeNoResult) {
  RandomOptions options;
  options.joints = 7;
  options.external_forces = 1;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    options.aligned = seed % 3 == 0 ? 0.5 : 1;
    options.mimic = seed % 4 == 0 ? 0.4 : 0;
    options.floating_base = seed % 5 == 0;
    options.mix.ball = seed % 6 == 5 ? 4 : 0;
    SCOPED_TRACE(described(seed, options));
    expect_same_motion(random_mechanism(seed, options), seed);
  }
}

/// A transform rotated by `angle` about z before and after the placement Rx(0 or pi).
JointTransform<double> parallel_transform(double before, bool flipped, double after) {
  JointTransform<double> X;
  X.R.a = {std::cos(before), std::sin(before)};
  X.R.alpha = {flipped ? -1.0 : 1.0, 0.0};
  X.turn = {std::cos(after), std::sin(after)};
  return X;
}

TEST(DeferredRotations, JoinAcrossParallelAndOppositeAxes) {
  for (const bool flipped : {false, true}) {
    const JointTransform<double> apart = parallel_transform(0.7, flipped, 1.9);
    JointTransform<double> joined = apart;
    join_rotations(joined);
    EXPECT_EQ(joined.R.a.s, 0);
    for (const Vector3<double>& v :
         {Vector3<double>{1, 0, 0}, Vector3<double>{0, 1, 0}, Vector3<double>{0, 0, 1}}) {
      const Vector3<double> difference = apart.to_parent(v) - joined.to_parent(v);
      EXPECT_LT(std::sqrt(dot(difference, difference)), 1e-15) << flipped;
    }
  }
}

}  // namespace
}  // namespace treeline::tests
