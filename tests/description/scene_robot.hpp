#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "diagnosed.hpp"

/// The robot for tests of scenes.
namespace treeline {

inline const std::string kBody =
    "<inertial><mass value='1'/>"
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";

/// base -shoulder-> upper -elbow-> fore -flange-> tool, and base -slide-> rail, -follow-> door with
/// follow mimicking slide.
inline Robot make_robot(const std::string& name = "two arm-1", const std::string& body = kBody) {
  const auto link = [&](const std::string& n) {
    return "<link name='" + n + "'>" + body + "</link>";
  };
  const auto joint = [](const std::string& n, const std::string& type, const std::string& parent,
                        const std::string& child, const std::string& inside) {
    return "<joint name='" + n + "' type='" + type + "'><parent link='" + parent +
           "'/><child link='" + child + "'/>" + inside + "</joint>";
  };
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='" + name + "'>" + link("base") + link("upper") + link("fore") + link("tool") +
          link("rail") + link("door") + joint("shoulder", "continuous", "base", "upper", "") +
          joint("elbow", "revolute", "upper", "fore",
                "<limit lower='-1' upper='1' effort='1' velocity='1'/>") +
          joint("flange", "fixed", "fore", "tool", "") +
          joint("slide", "prismatic", "base", "rail",
                "<limit lower='0' upper='1' effort='1' velocity='1'/>") +
          joint("follow", "continuous", "base", "door", "<mimic joint='slide'/>") + "</robot>",
      "r.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value();
}

/// A scene, and what must be said of it.
struct ToldScene {
  std::string text;
  Expected expected;
};

/// Reads each scene for the robot above. An error must leave no scene, a warning or note must.
inline void expect_told(const std::vector<ToldScene>& scenes) {
  const Robot robot = make_robot();
  for (const ToldScene& each : scenes) {
    SCOPED_TRACE(each.text);
    Diagnostics diagnostics;
    const auto scene = parse_scene(each.text, "bad.yaml", robot, diagnostics);
    EXPECT_EQ(scene.has_value(), each.expected.severity != Severity::error);
    expect_diagnosed(diagnostics, "bad.yaml", each.expected);
  }
}

}  // namespace treeline
