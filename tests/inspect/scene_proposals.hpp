#pragma once

// Robots as text, and what is proposed for them as text, to compare.

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "inspect/propose_scene.hpp"

namespace treeline::test {

inline Robot read(const std::string& text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(text, "r.urdf", diagnostics);
  EXPECT_TRUE(robot);
  return robot.value();
}

inline Robot read_own(const std::string& name) {
  Diagnostics diagnostics;
  return read_urdf(std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/" + name + ".urdf",
                   diagnostics)
      .value();
}

inline Scene read_back(const Robot& robot, const SceneProposal& proposal) {
  Diagnostics diagnostics;
  const std::string text = print_scene(robot, proposal, "r.urdf", {Function::gravity});
  const auto scene = parse_scene(text, "scene.yaml", robot, diagnostics);
  EXPECT_TRUE(scene) << text;
  for (const Diagnostic& d : diagnostics.list()) {
    EXPECT_NE(d.severity, Severity::error) << to_string(d) << '\n' << text;
  }
  return scene.value_or(Scene{});
}

inline std::string rows_of(const ScenePoint& point) {
  const std::array<const char*, 6> names = {"x", "y", "z", "rx", "ry", "rz"};
  std::string list;
  for (std::size_t i = 0; i < 6; ++i) list += point.rows[i] ? std::string(names[i]) + " " : "";
  return list;
}

inline std::string list_points(const SceneProposal& proposal) {
  std::string list;
  for (const ScenePoint& point : proposal.points) list += point.link + ": " + rows_of(point) + "; ";
  return list;
}

inline const std::string kBody =
    "<inertial><mass value='1'/><origin xyz='0.1 0 -0.1'/>"
    "<inertia ixx='.1' ixy='0' ixz='0' iyy='.1' iyz='0' izz='.1'/></inertial>";

/// Joins links parent - child pairwise by joints that rotate about the axis.
inline std::string joined(const std::string& parent, const std::string& child,
                          const std::string& axis, const std::string& type = "continuous") {
  return "<link name='" + child + "'>" + kBody + "</link><joint name='" + child + "_joint' type='" +
         type + "'><origin xyz='0.2 0.1 -0.3'/><parent link='" + parent + "'/><child link='" +
         child + "'/><axis xyz='" + axis + "'/></joint>";
}

inline std::string robot_text(const std::string& root, const std::string& inside) {
  return "<robot name='r'><link name='" + root + "'>" + kBody + "</link>" + inside + "</robot>";
}

inline std::string leg(const std::string& name) {
  return joined("trunk", name + "_hip", "1 0 0") + joined(name + "_hip", name + "_thigh", "0 1 0") +
         joined(name + "_thigh", name + "_calf", "0 1 0") +
         joined(name + "_calf", name + "_foot", "", "fixed");
}

}  // namespace treeline::test
