#include "bench/plan_builds.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "check/fixture.hpp"

// Variants that are planned, before anything runs. Would catch: a first route that is not the
// emitted one, a routine that is measured as lines, a variant that is lost, and code that is
// measured twice.

namespace treeline::tests {
namespace {

using Names = std::map<Function, std::multiset<std::string>>;

Names names_of(const std::vector<VariantBuild>& builds) {
  Names names;
  for (const VariantBuild& build : builds) {
    for (const Variant& variant : build.variants) {
      names[variant.function].insert(variant.name);
      names[variant.function].insert(variant.repeats.begin(), variant.repeats.end());
    }
  }
  return names;
}

TEST(GenerateRoutes, StartWithTheOneThatIsEmitted) {
  const Subjects subjects = load("puma560");
  const Mechanism& mechanism = subjects.generation.mechanism;
  for (const Function function : {Function::forward_dynamics, Function::lambda}) {
    const auto routes = generate_routes(mechanism, function, RouteOptions{8});
    const GeneratedFunction emitted = generate_function(mechanism, function, RouteOptions{8});
    EXPECT_EQ(key_of(routes.front().chosen.route), key_of(emitted.chosen.route));
    EXPECT_EQ(routes.front().chosen.count.flops(), emitted.chosen.count.flops());
    std::set<std::string> seen;
    for (const GeneratedFunction& route : routes) seen.insert(route.chosen.route.algorithm);
    EXPECT_EQ(seen.size(), routes.size());
    EXPECT_GE(routes.size(), 2U);
  }
}

TEST(GenerateRoutes, KeepRoutinesBehindLines) {
  const Subjects subjects = load("puma560");
  const auto routes = generate_routes(subjects.generation.mechanism,
                                      Function::forward_dynamics_derivatives, RouteOptions{8});
  EXPECT_TRUE(std::any_of(routes.begin(), routes.end(), [](const GeneratedFunction& route) {
    return route.program.ending != nullptr;
  }));
}

TEST(PlanBuilds, HaveEveryVariantOnce) {
  Subjects subjects = load("puma560");
  subjects.scene.functions = {Function::inverse_dynamics, Function::forward_dynamics};
  Diagnostics diagnostics;
  const auto builds = plan_builds(subjects.robot, subjects.scene, "-O1", {}, diagnostics);
  ASSERT_TRUE(builds);
  EXPECT_EQ(builds->front().variants.size(), 2U);
  const Names names = names_of(*builds);
  for (const VariantBuild& build : *builds) {
    for (const Variant& variant : build.variants) {
      EXPECT_EQ(variant.whole, variant.name != "sines given" && variant.states == 1);
    }
  }
  for (const auto& [function, found] : names) {
    for (const char* name :
         {"double, 8 lanes", "double, 4 lanes", "double, 1 lane", "float, 8 lanes",
          "float, 4 lanes", "float, 1 lane", "full inertias", "accuracy: best", "accuracy: fastest",
          "sines given", "sines of the C library", "not contracted", "C99", "8 states a call"}) {
      EXPECT_EQ(found.count(name), 1U) << function_name(function) << ": " << name;
    }
  }
  EXPECT_EQ(names.at(Function::inverse_dynamics).size(), 14U);
  EXPECT_EQ(
      names.at(Function::forward_dynamics).count("route: articulated bodies, Chang table 4.2"), 1U);
}

TEST(PlanBuilds, FullInertiasCostOperations) {
  Subjects subjects = load("puma560");
  subjects.scene.functions = {Function::inverse_dynamics};
  Diagnostics diagnostics;
  const auto builds = plan_builds(subjects.robot, subjects.scene, "-O1", {}, diagnostics);
  ASSERT_TRUE(builds);
  std::map<std::string, int> flops;
  for (const VariantBuild& build : *builds) {
    for (const Variant& variant : build.variants) {
      flops[variant.name] = variant.flops;
    }
  }
  EXPECT_GT(flops.at("full inertias"), flops.at("double, 8 lanes") * 11 / 10);
}

}  // namespace
}  // namespace treeline::tests
