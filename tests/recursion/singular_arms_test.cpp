#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "mechanism/build_mechanism.hpp"
#include "program/evaluate.hpp"
#include "random_mechanism.hpp"
#include "recursion/routes/trace_function.hpp"

// Typical arms with a tool of six rows: every function by every route is finite at q = 0, at all
// limits, folded, stretched, and near such states. Would catch: a division without a law, a law
// whose border has the wrong size, and a quaternion that is assumed to have length 1.

namespace treeline::tests {
namespace {

struct Arm {
  const char* name;
  const char* tool;
  bool floating = false;
};

/// A link of 1 kg with a joint before it, `axis` and `origin` as in URDF.
std::string link_behind(int i, const std::string& type, const std::string& axis,
                        const std::string& origin) {
  const std::string n = std::to_string(i), before = std::to_string(i - 1);
  return "<link name='l" + n +
         "'><inertial><origin xyz='0.1 0.05 0.02'/><mass value='1'/><inertia ixx='0.01' "
         "iyy='0.02' izz='0.015' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='j" +
         n + "' type='" + type + "'><parent link='l" + before + "'/><child link='l" + n +
         "'/><origin xyz='" + origin + "'/><axis xyz='" + axis +
         "'/><limit lower='-2' upper='2' effort='1' velocity='1'/></joint>";
}

std::string urdf_of(const std::string& links) {
  return "<robot name='r'><link name='l0'/>" + links + "</robot>";
}

std::string scara() {
  return urdf_of(link_behind(1, "revolute", "0 0 1", "0 0 0.4") +
                 link_behind(2, "revolute", "0 0 1", "0.3 0 0") +
                 link_behind(3, "prismatic", "0 0 1", "0.25 0 0") +
                 link_behind(4, "revolute", "0 0 1", "0 0 -0.1"));
}

std::string gantry() {
  return urdf_of(link_behind(1, "prismatic", "1 0 0", "0 0 1") +
                 link_behind(2, "prismatic", "0 1 0", "0 0 0") +
                 link_behind(3, "prismatic", "0 0 1", "0 0 0"));
}

std::string mobile_arm() {
  return urdf_of(link_behind(1, "prismatic", "1 0 0", "0 0 0") +
                 link_behind(2, "prismatic", "0 1 0", "0 0 0") +
                 link_behind(3, "continuous", "0 0 1", "0 0 0") +
                 link_behind(4, "revolute", "0 0 1", "0 0 0.5") +
                 link_behind(5, "revolute", "0 1 0", "0.1 0 0.1") +
                 link_behind(6, "revolute", "0 1 0", "0.4 0 0"));
}

/// States in which robots start and end, and states that they pass.
std::vector<std::vector<double>> telling_states(const Mechanism& mechanism) {
  constexpr double kQuarterTurn = 1.5707963267948966;
  std::vector<std::vector<double>> states(1, std::vector<double>(mechanism.coordinates.size(), 0));
  for (const double turns : {-2.0, -1.0, 1.0, 2.0, 0.5}) {
    states.emplace_back(states.front().size(), turns * kQuarterTurn);
  }
  for (const bool upper : {false, true}) {
    std::vector<double> q;
    for (const Coordinate& coordinate : mechanism.coordinates) {
      q.push_back(std::clamp(upper ? coordinate.upper : coordinate.lower, -100.0, 100.0));
    }
    states.push_back(q);
  }
  Rng rng(7);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> q;
    for (std::size_t j = 0; j < states.front().size(); ++j) {
      const double next = rng.chance(0.5) ? 0 : std::pow(10, -rng.uniform(1, 17));
      q.push_back((rng.below(5) - 2) * kQuarterTurn + next);
    }
    states.push_back(q);
  }
  return states;
}

void expect_finite(const Robot& robot, const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(scene_text, "scene.yaml", robot, diagnostics);
  ASSERT_TRUE(scene);
  const Mechanism mechanism = reduced_mechanism(robot, *scene);
  const auto states = telling_states(mechanism);
  std::size_t calls = 0;
  for (const Function function : scene->functions) {
    for (const Program& program : trace_function(mechanism, function)) {
      for (const auto& q : states) {
        std::vector<std::vector<double>> arguments;
        for (const Argument& argument : program.arguments) {
          const auto size = static_cast<std::size_t>(argument.rows);
          arguments.push_back(argument.name == "q" ? q : std::vector<double>(size, 0.7));
        }
        for (const auto& result : evaluate<double>(program, arguments)) {
          ++calls;
          ASSERT_TRUE(
              std::all_of(result.begin(), result.end(), [](double x) { return std::isfinite(x); }))
              << function_name(function) << " by " << describe(program.route) << ", q0 "
              << q.front();
        }
      }
    }
  }
  EXPECT_GE(calls, 1000U);
}

TEST(SingularArms, ArePublishedOnesAndFinite) {
  for (const Arm& arm :
       {Arm{"fr3", "fr3_link8"}, Arm{"iiwa14_drake", "iiwa_link_ee"}, Arm{"ur5", "tool0"},
        Arm{"ur5", "tool0", true}, Arm{"abb_irb4600_ct", "link6"}}) {
    SCOPED_TRACE(arm.name);
    Diagnostics diagnostics;
    const auto robot =
        read_urdf(data_file(std::string("published/") + arm.name + ".urdf"), diagnostics);
    ASSERT_TRUE(robot);
    expect_finite(*robot, std::string("base: ") + (arm.floating ? "floating" : "fixed") +
                              "\noperational_points: [{name: tool, link: " + arm.tool + "}]\n");
  }
}

TEST(SingularArms, AreSimpleOnesWithMoreRowsThanFreedomsAndFinite) {
  for (const std::string& text : {scara(), gantry(), mobile_arm()}) {
    Diagnostics diagnostics;
    const auto robot = parse_urdf(text, "r.urdf", diagnostics);
    ASSERT_TRUE(robot);
    const std::string last = robot->links.back().name;
    for (const char* rows : {"[x, y, z, rx, ry, rz]", "[x, y, z]", "[rz]", "[z, ry]"}) {
      SCOPED_TRACE(last + " " + rows);
      expect_finite(*robot, "base: fixed\noperational_points: [{name: tool, link: " + last +
                                ", rows: " + rows + "}, {name: half, link: l2, rows: [x]}]\n");
    }
  }
}

}  // namespace
}  // namespace treeline::tests
