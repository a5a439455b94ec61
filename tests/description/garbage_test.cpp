// Would catch: a crash, a hang or undefined behaviour on damaged input (run with sanitizers), and a
// reader that returns nothing without an error, or something together with an error.
#include <gtest/gtest.h>

#include <random>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

const std::string kUrdf = R"(<?xml version="1.0"?>
<robot name="r" version="1.0"><!-- comment -->
  <link name="a"><inertial><origin xyz="0 0 1" rpy="0 1 0"/><mass value="1.5"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="b"><visual/><inertial><mass value="2"/></inertial></link><link name="c"/>
  <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/><dynamics damping="1"/></joint>
  <joint name="k" type="prismatic"><parent link="a"/><child link="c"/><origin xyz="1 2 3"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/><mimic joint="j" multiplier="2"/></joint>
  <gazebo reference="a"><mu1>1</mu1></gazebo>
</robot>
)";

const std::string kScene = R"(name: r
base: floating
gravity: [0, 0, -9.81]
operational_points:
  - name: tool
    link: b
    origin: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}
    rows: [x, y, rz]
    axes: local
external_forces: [{name: grip, link: c}]
functions: [inverse_dynamics, control_torque]
locked: {j: 0.5}
)";

void read_urdf_text(const std::string& text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(text, "garbage.urdf", diagnostics);
  EXPECT_EQ(robot.has_value(), !diagnostics.has_errors()) << text << to_string(diagnostics);
}

void read_scene_text(const std::string& text) {
  static const Robot robot = [] {
    Diagnostics ignored;
    return parse_urdf(kUrdf, "sound.urdf", ignored).value();
  }();
  Diagnostics diagnostics;
  const auto scene = parse_scene(text, "garbage.yaml", robot, diagnostics);
  EXPECT_EQ(scene.has_value(), !diagnostics.has_errors()) << text << to_string(diagnostics);
}

/// Replaces, removes, doubles or moves a few bytes. Half of the new bytes have a meaning in XML or
/// YAML.
std::string damaged(std::string text, std::mt19937_64& random) {
  static const std::string kMeaningful = "<>/&'\"=[]{}:,-#!*|?%@ \n\t0123456789.e+;\\$\xFF";
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (std::size_t changes = 1 + below(4); changes > 0 && !text.empty(); --changes) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(16);
    switch (below(4)) {
      case 0:
        text[at] =
            below(2) == 0 ? static_cast<char>(below(256)) : kMeaningful[below(kMeaningful.size())];
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      default:
        text.insert(at, 1, kMeaningful[below(kMeaningful.size())]);
    }
  }
  return text;
}

TEST(Garbage, TheSoundTextsAreSound) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(kUrdf, "sound.urdf", diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_TRUE(parse_scene(kScene, "sound.yaml", *robot, diagnostics)) << to_string(diagnostics);
}

TEST(Garbage, TruncatedUrdf) {
  for (std::size_t length = 0; length < kUrdf.size(); ++length)
    read_urdf_text(kUrdf.substr(0, length));
}

TEST(Garbage, DamagedUrdf) {
  std::mt19937_64 random(20240601);
  for (int i = 0; i < 3000; ++i) read_urdf_text(damaged(kUrdf, random));
}

TEST(Garbage, TruncatedScene) {
  for (std::size_t length = 0; length < kScene.size(); ++length)
    read_scene_text(kScene.substr(0, length));
}

TEST(Garbage, DamagedScene) {
  std::mt19937_64 random(20240602);
  for (int i = 0; i < 3000; ++i) read_scene_text(damaged(kScene, random));
}

TEST(Garbage, RandomBytes) {
  std::mt19937_64 random(20240603);
  for (int i = 0; i < 500; ++i) {
    std::string text(random() % 300, ' ');
    for (char& c : text) c = static_cast<char>(random());
    read_urdf_text(text);
    read_scene_text(text);
  }
}

TEST(Garbage, NestedScene) {
  for (const char* opening : {"[", "{a: ", "- ", "? ", "&a ", "!!t "}) {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += opening;
    read_scene_text(text);
  }
}

// Would catch: recursion over the tree, here or in a library, that overflows the stack, and names
// that are compared pair by pair.
TEST(Garbage, LongestChain) {
  std::string text = "<robot name='r'><link name='l4095'/>";
  for (int i = 4094; i >= 0; --i) {
    const std::string n = std::to_string(i), m = std::to_string(i + 1);
    text += "<link name='l" + n + "'/><joint name='j" + n + "' type='fixed'><parent link='l" + n +
            "'/><child link='l" + m + "'/></joint>";
  }
  read_urdf_text(text + "</robot>");
  read_urdf_text(text + "<link name='extra'/></robot>");
}

}  // namespace
}  // namespace treeline
