#include <gtest/gtest.h>

#include <functional>

#include "mechanism/build_mechanism.hpp"
#include "random_mechanism.hpp"
#include "recursion/template_results.hpp"

// Every reduction leaves the equations of motion unchanged: all functions, in 50 digits with
// unrounded constants, for the mechanism after lumping, after regrouping inertias, and after
// placing frames, compared with the interpreter for the robot as written in the files. Would catch:
// a reduction that is wrong in any term, however small, for any kind of joint at any place of a
// tree.

namespace treeline::tests {
namespace {

/// Digits of the 50 that cancellation and conditioning may cost.
constexpr double kTolerance = 1e-40;

struct Stage {
  const char* name;
  std::function<Mechanism(const RandomMechanism&)> reduce;
};

const std::vector<Stage>& stages() {
  static const std::vector<Stage> kStages{
      {"lumped", [](const RandomMechanism& m) { return build_mechanism(m.robot, m.scene); }},
      {"regrouped",
       [](const RandomMechanism& m) {
         Mechanism mechanism = build_mechanism(m.robot, m.scene);
         regroup_inertias(mechanism);
         return mechanism;
       }},
      {"placed without regrouping",
       [](const RandomMechanism& m) {
         Mechanism mechanism = build_mechanism(m.robot, m.scene);
         place_frames(mechanism);
         return mechanism;
       }},
      {"regrouped and placed",
       [](const RandomMechanism& m) { return reduced_mechanism(m.robot, m.scene); }},
      {"as accurate as can be", [](const RandomMechanism& m) {
         Scene scene = m.scene;
         scene.accuracy = Accuracy::best;
         return reduced_mechanism(m.robot, scene);
       }}};
  return kStages;
}

/// Compares all functions by all routes at one state.
void expect_same_equations(const RandomMechanism& made, Rng& rng) {
  const Oracle<Digits50> oracle(made.robot, made.scene);
  if (oracle.model().nv == 0) return;
  const Inputs<Digits50> in = oracle.random_inputs(rng);
  const Yardstick size = yardstick(oracle, in);
  std::vector<std::pair<Function, Results<Digits50>>> expected;
  for (const Function function : kDefaultFunctions) {
    if (permits(function, oracle.has_points(), size)) {
      expected.emplace_back(function, oracle.results(function, in));
    }
  }
  for (const Stage& stage : stages()) {
    const TemplateRun<Digits50> run(stage.reduce(made), in);
    for (const auto& [function, truth] : expected) {
      for (const auto& [route, results] : run.results(function)) {
        EXPECT_LE(relative_error(results, truth, size.least_scale(function)),
                  kTolerance * size.growth(function))
            << stage.name << ", " << function_name(function) << ", " << route;
      }
    }
  }
}

void expect_same_equations(const RandomOptions& options, std::uint64_t first_seed, int count) {
  for (std::uint64_t seed = first_seed; seed < first_seed + static_cast<std::uint64_t>(count);
       ++seed) {
    SCOPED_TRACE(described(seed, options));
    Rng rng(seed + 1000);
    expect_same_equations(random_mechanism(seed, options), rng);
  }
}

TEST(Invariance, Chains) {
  RandomOptions options;
  options.joints = 7;
  options.branching = 0;
  options.external_forces = 1;
  expect_same_equations(options, 100, 12);
}

TEST(Invariance, TreesWithSeveralPointsAndForces) {
  RandomOptions options;
  options.joints = 10;
  options.branching = 0.6;
  options.operational_points = 2;
  options.all_rows = false;
  options.external_forces = 2;
  expect_same_equations(options, 200, 10);
}

TEST(Invariance, FloatingBases) {
  RandomOptions options;
  options.joints = 7;
  options.floating_base = true;
  options.operational_points = 2;
  options.external_forces = 1;
  expect_same_equations(options, 300, 8);
}

TEST(Invariance, FloatingAndPlanarJointsWithinTrees) {
  RandomOptions options;
  options.joints = 5;
  options.mix.floating = 2;
  options.mix.planar = 3;
  options.external_forces = 1;
  expect_same_equations(options, 400, 10);
}

TEST(Invariance, BallJoints) {
  RandomOptions options;
  options.joints = 5;
  options.mix = {3, 1, 2, 1, 1, 1, 6};
  options.external_forces = 1;
  expect_same_equations(options, 450, 8);
  options.floating_base = true;
  expect_same_equations(options, 470, 4);
}

TEST(Invariance, MimicsAndLockedJoints) {
  RandomOptions options;
  options.joints = 9;
  options.mimic = 0.4;
  options.locked = 0.2;
  options.external_forces = 1;
  options.all_rows = false;
  expect_same_equations(options, 500, 12);
}

// Nothing is aligned: the general formulas, without any zero.
TEST(Invariance, NothingAligned) {
  RandomOptions options;
  options.joints = 6;
  options.aligned = 0;
  expect_same_equations(options, 600, 6);
}

// Everything is aligned: parallel and intersecting axes, for which common normals are not unique.
TEST(Invariance, EverythingAligned) {
  RandomOptions options;
  options.joints = 9;
  options.aligned = 1;
  options.massless = 1;
  options.mix.fixed = 3;
  options.external_forces = 1;
  expect_same_equations(options, 700, 10);
}

}  // namespace
}  // namespace treeline::tests
