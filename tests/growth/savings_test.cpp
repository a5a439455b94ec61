#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "generation/generate_code.hpp"
#include "generation/measure_savings.hpp"
#include "scenes_of_robots.hpp"

// Functions that a scene does not need are not emitted, and an addition to a scene costs only
// itself. Would catch: a function that grows because of another one, files that depend on other
// requests of the scene, and outdated figures in docs/evidence/generated-code.md.

namespace treeline::growth {
namespace {

std::map<std::string, RobotInScene> scenes_by_name() {
  Diagnostics diagnostics;
  std::map<std::string, RobotInScene> scenes;
  for (RobotInScene& made : scenes_of_robots(TREELINE_ROBOTS_DIR, diagnostics)) {
    const std::string name = made.scene.name;
    scenes.emplace(name, std::move(made));
  }
  EXPECT_FALSE(diagnostics.has_errors());
  return scenes;
}

/// A row of the table of docs/evidence/generated-code.md: `| scene | 3 of 16 | 22 % | 19 % |`.
struct Promise {
  int functions = 0, possible = 0;
  double flops_percent = 0, bytes_percent = 0;
};

std::map<std::string, Promise> read_promises() {
  std::ifstream page(TREELINE_PAGE);
  std::map<std::string, Promise> promises;
  for (std::string line; std::getline(page, line);) {
    std::istringstream words(line);
    std::string bar, scene, of, percent;
    Promise p;
    words >> bar >> scene >> bar >> p.functions >> of >> p.possible >> bar >> p.flops_percent >>
        percent >> bar >> p.bytes_percent;
    if (words && of == "of" && percent == "%") promises[scene] = p;
  }
  return promises;
}

TEST(Savings, AreThoseOfThePage) {
  const auto promises = read_promises();
  const auto scenes = scenes_by_name();
  ASSERT_GE(scenes.size(), 10U);
  for (const auto& [name, made] : scenes) {
    SCOPED_TRACE(name);
    ASSERT_TRUE(promises.contains(name));
    const Promise& promise = promises.at(name);
    const Scene& scene = made.scene;
    EXPECT_EQ(promise.functions, static_cast<int>(scene.functions.size()));
    EXPECT_EQ(promise.possible, static_cast<int>(possible_functions(made.robot, scene).size()));
  }
  // Percentages change a little whenever an algorithm improves. The large robots take too long.
  for (const char* name : {"planar3r", "puma560_contact", "puma560_float", "samm_base_locked"}) {
    SCOPED_TRACE(name);
    const auto& [robot, scene] = scenes.at(name);
    const Savings savings = measure_savings(robot, scene);
    const Savings::Sum some = savings.emitted();
    const Savings::Sum all = savings.possible();
    EXPECT_NEAR(promises.at(name).flops_percent, 100.0 * some.flops / all.flops, 4);
    EXPECT_NEAR(promises.at(name).bytes_percent,
                100.0 * static_cast<double>(some.bytes) / static_cast<double>(all.bytes), 4);
  }
}

Generation generate(const RobotInScene& made) {
  Diagnostics diagnostics;
  auto generation =
      generate_code(made.robot, made.scene, {"robot.urdf", "", "scene.yaml", ""}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return generation ? std::move(*generation) : Generation{};
}

std::map<std::string, std::string> sources_of(const Generation& generation) {
  std::map<std::string, std::string> sources;
  for (const GeneratedFile& file : generation.files) {
    // id.cpp has a digest of all files.
    if (!file.name.ends_with(".cpp") || file.name == "id.cpp") continue;
    sources[file.name] = file.text;
  }
  return sources;
}

int flops_of(const Generation& generation, Function function) {
  for (const GeneratedFunction& generated : generation.functions) {
    if (generated.function == function) return generated.chosen.count.flops();
  }
  return 0;
}

/// Expects that all files emitted before are emitted again with the same bytes, except those of
/// these functions.
void expect_kept(const RobotInScene& before, const RobotInScene& after,
                 const std::vector<Function>& concerned) {
  auto kept = sources_of(generate(before));
  const auto now = sources_of(generate(after));
  for (const Function function : concerned) {
    kept.erase(std::string(function_name(function)) + ".cpp");
  }
  EXPECT_FALSE(kept.empty());
  for (const auto& [name, text] : kept) {
    ASSERT_TRUE(now.contains(name)) << name;
    EXPECT_TRUE(now.at(name) == text) << name;
  }
}

ScenePoint point_on(const char* name, const char* link) {
  ScenePoint point;
  point.name = name;
  point.link = link;
  return point;
}

TEST(Savings, AnotherTaskLeavesTheRestAsItWas) {
  const RobotInScene arm = scenes_by_name().at("puma560_contact");
  RobotInScene with_task = arm;
  with_task.scene.operational_points.front().rows = {true, true, true, false, false, false};
  RobotInScene without = with_task;
  without.scene.operational_points.clear();
  std::erase(without.scene.functions, Function::control_torque);
  expect_kept(without, with_task, {});
}

TEST(Savings, AnotherContactLeavesTheRestAsItWas) {
  const RobotInScene tumbler = scenes_by_name().at("tumbler");
  RobotInScene fewer = tumbler;
  fewer.scene.contacts.pop_back();
  expect_kept(fewer, tumbler,
              {kContactFunctions.begin(), kContactFunctions.end() - 1});  // links need no contact
}

TEST(Savings, AnObjectLeavesTheRestAsItWas) {
  const RobotInScene arm = scenes_by_name().at("puma560_float");
  RobotInScene holding = arm;
  SceneObject object;
  object.name = "box";
  object.inertial.mass = 2;
  object.inertial.ixx = object.inertial.iyy = object.inertial.izz = 0.02;
  object.grasps = {{"tool", {}}};
  holding.scene.objects = {object};
  holding.scene.functions.push_back(Function::object_state);
  holding.scene.functions.push_back(Function::object_control_torque);
  expect_kept(arm, holding, {});
}

/// Cost of a function for some of the tumbler's feet.
int cost_for(const RobotInScene& tumbler, Function function, const std::vector<std::size_t>& feet) {
  RobotInScene made = tumbler;
  made.scene.lanes = 1;
  made.scene.contacts.clear();
  for (const std::size_t foot : feet) made.scene.contacts.push_back(tumbler.scene.contacts[foot]);
  made.scene.functions = {function};
  return flops_of(generate(made), function);
}

// Two contacts never cost more than the sum of either alone, and less if they share a part of the
// path.
TEST(Savings, AContactAddsNoMoreThanItsOwnCost) {
  const RobotInScene tumbler = scenes_by_name().at("tumbler");
  for (const Function function : {Function::contact_motion, Function::effective_mass}) {
    SCOPED_TRACE(function_name(function));
    const int front = cost_for(tumbler, function, {0});
    const int hind = cost_for(tumbler, function, {3});
    const int both = cost_for(tumbler, function, {0, 3});
    EXPECT_GT(both, std::max(front, hind));
    EXPECT_LE(both, front + hind);
  }
}

// Each further row of a task adds itself and its couplings: differences of Lambda^-1 grow by one
// coupling per row.
TEST(Savings, ARowAddsItselfAndItsCouplings) {
  const RobotInScene arm = scenes_by_name().at("puma560");
  std::vector<int> costs;
  for (std::size_t rows = 1; rows <= 3; ++rows) {
    RobotInScene made = arm;
    made.scene.lanes = 1;
    made.scene.functions = {Function::bias_acceleration, Function::lambda_inverse};
    made.scene.operational_points = {point_on("tool", "tool")};
    made.scene.operational_points.front().rows.fill(false);
    for (std::size_t row = 0; row < rows; ++row) {
      made.scene.operational_points.front().rows[row] = true;
    }
    costs.push_back(flops_of(generate(made), Function::lambda_inverse));
  }
  const int second = costs[1] - costs[0];
  const int third = costs[2] - costs[1];
  EXPECT_GT(second, 0);
  EXPECT_LT(second, costs[0]);
  EXPECT_LT(third, costs[0]);
}

}  // namespace
}  // namespace treeline::growth
