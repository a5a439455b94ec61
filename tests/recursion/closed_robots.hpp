#pragma once

#include <array>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "text/read_text_file.hpp"

/// Robots of tests/data/written with loops, and which joints their motors leave to these.
namespace treeline::tests {

struct ClosedRobot {
  const char* name;
  const char* urdf;
  std::string scene;
};

inline std::ostream& operator<<(std::ostream& out, const ClosedRobot& robot) {
  return out << robot.name;
}

inline std::string four_bar_scene(const std::string& rows, const std::string& passive) {
  return "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, 0.25]}, "
         "other_origin: {xyz: [0.3, 0, 0]}, rows: " +
         rows + "}]\npassive: " + passive + "\nfunctions: [constrained_forward_dynamics]\n";
}

/// Both passive joints of each leg or arm, and these.
inline std::string legs(int count, const std::string& first, const std::string& second,
                        const std::string& others) {
  std::string names;
  for (int k = 0; k < count; ++k) {
    const std::string number = "_" + std::to_string(k) + ", ";
    names.append(first).append(number).append(second).append(number);
  }
  return "passive: [" + names + others + "]\nfunctions: [constrained_forward_dynamics]\n";
}

inline const std::array<ClosedRobot, 6>& closed_robots() {
  static const std::array<ClosedRobot, 6> kRobots{
      {{"four_bar", "four_bar", four_bar_scene("[x, z]", "[coupler_joint, rocker_joint]")},
       {"four_bar_on_a_hinge", "four_bar",
        four_bar_scene("[x, y, z, rx, rz]", "[coupler_joint, rocker_joint]")},
       {"spatial_four_bar", "spatial_four_bar",
        "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, 0.4]}, "
        "other_origin: {xyz: [0.6, 0, 0]}, rows: [x, y, z]}]\n"
        "passive: [swing_joint, lift_joint, rocker_joint]\nfunctions: "
        "[constrained_forward_dynamics]\n"},
       {"delta", "delta", legs(3, "elbow", "sway", "slide_x, slide_y, slide_z")},
       {"delta_with_a_belt", "delta",
        "couplings: [{name: belt, joints: {shoulder_1: 1, shoulder_2: -1.5}, offset: 0.1}]\n" +
            legs(3, "elbow", "sway", "slide_x, slide_y, slide_z, shoulder_2")},
       {"stewart", "stewart", legs(6, "yaw", "pitch", "rim")}}};
  return kRobots;
}

/// Links of 3 kg and hinges of an arm whose last joint carries `tip`.
inline std::string arm_of(int joints, const std::string& tip) {
  std::string text = "<link name='pedestal'/>";
  std::string inner = "pedestal";
  const std::array<const char*, 3> axes{"0 0 1", "0 1 0", "1 0 0"};
  for (int k = 0; k < joints; ++k) {
    const std::string number = std::to_string(k);
    const std::string link = k + 1 < joints ? "beam_" + number : tip;
    if (link != tip) {
      text += "<link name='" + link +
              "'><inertial><origin xyz='0.1 0.02 0.2'/><mass value='3'/><inertia ixx='0.1' "
              "iyy='0.12' izz='0.05' ixy='0.01' ixz='0' iyz='0'/></inertial></link>";
    }
    text += "<joint name='arm_" + number + "' type='continuous'><parent link='" + inner +
            "'/><child link='" + link + "'/><origin xyz='0.1 0 0.4'/><axis xyz='" +
            axes.at(static_cast<std::size_t>(k % 3)) + "'/></joint>";
    inner = link;
  }
  return text;
}

/// `arm`: joints of an arm that carries the robot's root, which is the first link of its file.
inline std::pair<Robot, Scene> read_closed(const ClosedRobot& closed, int arm = 0) {
  Diagnostics diagnostics;
  const std::string file = data_file(std::string("written/") + closed.urdf + ".urdf");
  std::string text = read_text_file(file, diagnostics).value();
  if (arm > 0) {
    const std::size_t name = text.find("<link name=\"") + 12;
    const std::string root = text.substr(name, text.find('"', name) - name);
    text.insert(text.rfind("</robot>"), arm_of(arm, root));
  }
  auto robot = parse_urdf(text, file, diagnostics);
  if (!robot) throw std::runtime_error("the robot cannot be read");
  auto scene = parse_scene(closed.scene, "scene.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error("the scene cannot be read");
  return {std::move(*robot), std::move(*scene)};
}

}  // namespace treeline::tests
