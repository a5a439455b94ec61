#include <string>
#include <utility>
#include <vector>

#include "functions/function.hpp"
#include "tried_subjects.hpp"

// Every function of robots whose results vanish, entry by entry or all of them: gantries, arms
// without gravity along what they move, masses without moments, bodies that turn about their
// centres. Would catch a result of 0 that is judged by a size of 0, beside what 50 digits leave of
// terms that cancel: it was refused as a fault.

namespace treeline::tests {
namespace {

std::string link(const std::string& name, double mass, const std::string& center = "0 0 0",
                 double moment = 1) {
  const std::string m = std::to_string(moment);
  return "<link name='" + name + "'><inertial><origin xyz='" + center + "'/><mass value='" +
         std::to_string(mass) + "'/><inertia ixx='" + m + "' iyy='" + m + "' izz='" + m +
         "' ixy='0' ixz='0' iyz='0'/></inertial></link>";
}

std::string joint(const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& axis, const std::string& origin = "xyz='0 0 0'") {
  return "<joint name='to_" + child + "' type='" + type + "'><origin " + origin +
         "/><parent link='" + parent + "'/><child link='" + child + "'/><axis xyz='" + axis +
         "'/><limit lower='-2' upper='2' effort='10' velocity='3'/></joint>";
}

/// Robots without their base link `w`. The last body is always `c`.
const std::vector<std::pair<const char*, std::string>>& vanishing_robots() {
  static const std::vector<std::pair<const char*, std::string>> robots{
      {"gantry", link("a", 1) + link("b", 2) + link("c", 3) +
                     joint("prismatic", "w", "a", "1 0 0") + joint("prismatic", "a", "b", "0 1 0") +
                     joint("prismatic", "b", "c", "0 0 1")},
      {"slide and turn", link("a", 1) + link("c", 1) + joint("prismatic", "w", "a", "1 0 0") +
                             joint("revolute", "a", "c", "0 0 1")},
      {"tilted slide and turn",
       link("a", 1) + link("c", 2) +
           joint("prismatic", "w", "a", "0.6 0.8 0", "rpy='0.3 0.2 0.1'") +
           joint("revolute", "a", "c", "0.6 0 0.8", "xyz='0.1 0.2 0.3' rpy='0.5 0.4 0.3'")},
      {"spinning wheel", link("c", 2) + joint("continuous", "w", "c", "0 0 1")},
      {"points", link("a", 1, "0.3 0 0", 0) + link("c", 2, "0 0 0.4", 0) +
                     joint("revolute", "w", "a", "0 1 0") +
                     joint("revolute", "a", "c", "1 0 0", "xyz='0.5 0 0'")},
      {"scara", link("a", 2, "0.2 0 0") + link("c", 1, "0.1 0 0") +
                    joint("revolute", "w", "a", "0 0 1") +
                    joint("revolute", "a", "c", "0 0 1", "xyz='0.4 0 0'")},
      {"gimbal", link("a", 1) + link("b", 1) + link("c", 1) + joint("revolute", "w", "a", "0 0 1") +
                     joint("revolute", "a", "b", "0 1 0") + joint("revolute", "b", "c", "1 0 0")},
      {"cylinder", link("a", 1) + link("c", 1) + joint("prismatic", "w", "a", "0 0 1") +
                       joint("revolute", "a", "c", "0 0 1")},
      {"turns about one axis", link("a", 1) + link("c", 1) + joint("revolute", "w", "a", "1 0 0") +
                                   joint("revolute", "a", "c", "1 0 0")},
      {"plane", link("c", 1, "0.1 0 0") + joint("planar", "w", "c", "0 0 1")},
      {"ball", link("c", 1) + joint("ball", "w", "c", "1 0 0")},
      {"free body", link("c", 1) + joint("floating", "w", "c", "1 0 0")},
  };
  return robots;
}

Subjects with_all_functions(const std::string& robot, const std::string& scene_text) {
  Subjects subjects =
      read_unmade("<link name='w'/>" + robot,
                  scene_text +
                      "base: fixed\n"
                      "operational_points: [{name: hub, link: c, rows: [x]}]\n"
                      "contacts: [{name: touch, link: c, origin: {xyz: [0.1, 0, 0]}}]\n");
  subjects.scene.functions.assign(kSceneFunctions.begin(), kSceneFunctions.end());
  std::erase_if(subjects.scene.functions, [](Function function) {
    return needs_objects(function) || needs_constraints(function) ||
           function == Function::damped_control_torque;
  });
  subjects.generation = generate(subjects.robot, subjects.scene);
  return subjects;
}

void expect_right(const std::string& scene) {
  for (const auto& [name, robot] : vanishing_robots()) {
    const Subjects subjects = with_all_functions(robot, scene);
    EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{}) << name;
  }
}

TEST(VanishingResults, AreRightInEveryFunction) {
  expect_right("");
}

TEST(VanishingResults, OfWhatHasNoWeight) {
  expect_right("gravity: [0, 0, 0]\n");
}

TEST(VanishingResults, OfFloat) {
  expect_right("real: float\n");
}

// A size of 0 is no licence: what is not 0 beside it is found.
TEST(VanishingResults, AreNotTakenForGranted) {
  Subjects subjects = with_all_functions(vanishing_robots()[1].second, "");
  for (GeneratedFunction& generated : subjects.generation.functions) {
    if (generated.function != Function::coriolis_matrix) continue;
    const Graph::Scope scope(generated.program.graph);
    for (Expression& value : generated.program.results.front().values) {
      value = value + Expression(1e-9);
    }
  }
  EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{"coriolis_matrix"});
}

}  // namespace
}  // namespace treeline::tests
