#include "data/list_data.hpp"
#include "fixture.hpp"
#include "oracle/bound.hpp"

// Would catch: a bound that leaves out how a solve amplifies the errors of the solve before it, so
// that correct code is called wrong at some states.

namespace treeline::tests {
namespace {

/// Largest share of its bound that a function's graph takes at these states.
double largest_share(const Subjects& subjects, int states, std::uint64_t seed) {
  ReferenceOptions options;
  options.states = states;
  options.seed = seed;
  const auto references =
      make_references(subjects.robot, subjects.scene, subjects.generation, options);
  const auto functions = all_callable(subjects.generation);
  double largest = 0;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Bound bound = find_bound(i, functions[i].function, references);
    for (const StateReference& reference : references) {
      const FunctionReference& at = reference.functions[i];
      if (at.singular) continue;
      const double error = error_in_ulp(at.graph, at, unit_of(subjects.scene.real));
      largest = std::max(largest, error / bound.at(at));
    }
  }
  return largest;
}

/// Two of these states displace the torso by metres: the error of Lambda^-1 by inertia propagation
/// is then up to 170 times the interpreter's and, unlike it, that of no M near the given one.
TEST(Bounds, HoldWhereALiftIsFarOut) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file("published/fetch.urdf"), diagnostics);
  ASSERT_TRUE(robot);
  const auto scene = parse_scene(R"(
base: floating
operational_points: [{name: hand, link: gripper_link}]
functions: [lambda_inverse, lambda, control_torque]
)",
                                 "scene.yaml", *robot, diagnostics);
  ASSERT_TRUE(scene);
  EXPECT_LT(largest_share({*robot, *scene, generate(*robot, *scene)}, 100, 1), 1);
}

/// In 60 such robots no error took more than 0.38 of its bound.
TEST(Bounds, HoldForFloatingJointsInFloatingTrees) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomOptions options;
    options.joints = 3 + static_cast<int>(seed % 6);
    options.floating_base = true;
    options.mix.floating = 3;
    options.mix.ball = seed % 2 == 0 ? 2 : 0;
    EXPECT_LT(largest_share(draw(seed, options), 40, seed), 1) << "seed " << seed;
  }
}

}  // namespace
}  // namespace treeline::tests
