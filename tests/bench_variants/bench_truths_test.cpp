#include "bench/bench_truths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "check/fixture.hpp"
#include "oracle/entries.hpp"

// States in which variants are measured. Would catch: quaternions that all have unit length, or
// none of which has, peers that are measured with quaternions of another length, numbers that float
// cannot hold, and constraints that states of double do not keep.

namespace treeline::tests {
namespace {

/// References of no function, because only the states matter here.
BenchTruths truths_of(const std::string& name, int states) {
  const Subjects subjects = load(name);
  BenchOptions options;
  options.states = states;
  return {subjects.robot, subjects.scene, {}, options};
}

/// Length error of the base's quaternion; q begins with the position and quaternion of the base.
double length_error(const State& state) {
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) square += state.q[i] * state.q[i];
  return std::abs(std::sqrt(square) - 1);
}

/// Counts the quaternions that have unit length up to the rounding of double, and those up to that
/// of float.
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

/// Largest velocity of a row that the scene holds.
double largest_slip(const Subjects& subjects, const StateReference& reference) {
  const auto subject = make_subject<double>(subjects.robot, subjects.scene);
  const auto J = interpreter::jacobian<double>(subject.model, subject.constraints,
                                               vector_of<double>(reference.state.q));
  return (J * vector_of<double>(reference.state.qd)).cwiseAbs().maxCoeff();
}

TEST(BenchTruths, OfDoubleKeepConstraints) {
  const Subjects subjects = load_unmade("humanoid24", "scene_stand.yaml");
  BenchOptions options;
  options.states = 6;
  const BenchTruths truths(subjects.robot, subjects.scene, {}, options);
  EXPECT_FALSE(truths.lacks_held_states());
  const Variant in_double{Function::gravity, VariantGroup::emitted, "double", Real::float64};
  EXPECT_EQ(&truths.timed(), &truths.of(in_double));
  const Variant peer{Function::gravity, VariantGroup::peer, "peer", Real::float64};
  EXPECT_EQ(count_lengths(truths.of(peer)), std::pair(6, 0));
  EXPECT_EQ(count_lengths(truths.timed()), std::pair(6, 0));
  for (const StateReference& held : truths.timed()) EXPECT_LT(largest_slip(subjects, held), 1e-14);
  for (const StateReference& free : truths.in_float()) EXPECT_GT(largest_slip(subjects, free), 0.1);
}

TEST(BenchTruths, SayWhereNothingKeepsConstraints) {
  Subjects subjects = load_unmade("planar3r", "scene.yaml");
  SceneLoop loop;
  loop.first = {"far", subjects.robot.links.back().name, {{100, 0, 0}, {}}, Axes::local};
  loop.second = {"far", subjects.robot.links.front().name, {}, Axes::local};
  loop.first.rows = loop.second.rows = {true, true, false, false, false, false};
  subjects.scene.loops = {loop};
  BenchOptions options;
  options.states = 2;
  const BenchTruths truths(subjects.robot, subjects.scene, {}, options);
  EXPECT_TRUE(truths.lacks_held_states());
  EXPECT_EQ(&truths.timed(), &truths.in_float());
}

}  // namespace
}  // namespace treeline::tests
