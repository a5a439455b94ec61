#pragma once

#include <gtest/gtest.h>

#include <string>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "inspect/inspect_robot.hpp"

namespace treeline {

/// base (2 kg) -arm-> upper (3 kg at 0.5 along x, no body's inertia) -mount-> tool (1 kg at its
/// origin, 1 along x), base -slide-> left (4 kg), base -follow-> right (4 kg) mimicking slide.
/// Joint `arm` turns about z, the slides move along x.
inline const char* const kSample = R"(<robot name="two &quot;hands&quot;">
  <link name="base"><inertial><mass value="2"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="arm" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="2" effort="3" velocity="4"/></joint>
  <link name="upper"><inertial><origin xyz="0.5 0 0"/><mass value="3"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.4"/></inertial></link>
  <joint name="mount" type="fixed"><parent link="upper"/><child link="tool"/>
    <origin xyz="1 0 0"/></joint>
  <link name="tool"><inertial><mass value="1"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
  <joint name="slide" type="prismatic"><parent link="base"/><child link="left"/></joint>
  <link name="left"><inertial><mass value="4"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="follow" type="prismatic"><parent link="base"/><child link="right"/>
    <mimic joint="slide" multiplier="-0.5" offset="0.1"/></joint>
  <link name="right"><inertial><mass value="4"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>
)";

inline Report inspect_sample(const std::string& scene_text = "") {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(kSample, "sample.urdf", diagnostics);
  if (scene_text.empty()) return inspect_robot(robot.value(), std::nullopt);
  const auto scene = parse_scene(scene_text, "sample.yaml", robot.value(), diagnostics);
  EXPECT_TRUE(scene) << (diagnostics.has_errors() ? to_string(diagnostics.list().back()) : "");
  return inspect_robot(robot.value(), scene.value());
}

}  // namespace treeline
