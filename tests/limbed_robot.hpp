#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <optional>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline::tests {

/// A robot and a scene with its hands.
struct LimbedRobot {
  Robot robot;
  Scene scene;
};

/// Numbers of links, each behind a hinge, and of hands.
struct LimbedShape {
  int trunk = 4;
  int limbs = 0;
  int limb_links = 4;
  int hands = 1;
  [[nodiscard]] int links() const { return trunk + limbs * limb_links; }
};

namespace detail {

inline void add_link(Robot& robot, int parent) {
  const int child = static_cast<int>(robot.links.size());
  Inertial inertial;
  inertial.origin = {{0.03, -0.02, 0.15}, {0, 0, 0}};
  inertial.mass = 2.5;
  inertial.ixx = 0.03;
  inertial.iyy = 0.025;
  inertial.izz = 0.012;
  inertial.ixy = 0.002;
  inertial.ixz = -0.003;
  inertial.iyz = 0.004;
  robot.links.push_back({fmt::format("link_{}", child), inertial, 0});
  Joint joint;
  joint.name = fmt::format("joint_{}", child);
  joint.type = JointType::revolute;
  joint.parent = parent;
  joint.child = child;
  joint.origin = {{0.05, 0.1, 0.3}, {0.7, -0.4, 1.1}};
  joint.axis = {0, 0, 1};
  robot.joints.push_back(joint);
}

inline void add_hand(int link, LimbedRobot& made) {
  ScenePoint point;
  point.name = fmt::format("hand_{}", made.scene.operational_points.size());
  point.link = made.robot.links[static_cast<std::size_t>(link)].name;
  point.origin.xyz = {0.02, 0.03, 0.1};
  made.scene.operational_points.push_back(point);
}

}  // namespace detail

/// Makes a trunk of hinges with several limbs of hinges on its end. All links are equal and no axis
/// is along another one, so nothing vanishes that would not vanish for every robot. A point with
/// six rows, in world axes, is on the last link of each of the first `hands` limbs; without limbs,
/// points are on the last `hands` links of the trunk.
inline LimbedRobot make_limbed_robot(const LimbedShape& shape) {
  LimbedRobot made;
  Robot& robot = made.robot;
  robot.name = made.scene.name = "alike";
  robot.links.push_back({"base", std::nullopt, 0});
  robot.root = 0;
  for (int i = 0; i < shape.trunk; ++i) detail::add_link(robot, i);
  for (int limb = 0; limb < shape.limbs; ++limb) {
    for (int i = 0; i < shape.limb_links; ++i) {
      const int last = static_cast<int>(robot.links.size()) - 1;
      detail::add_link(robot, i == 0 ? shape.trunk : last);
    }
    const int tip = static_cast<int>(robot.links.size()) - 1;
    if (limb < shape.hands) detail::add_hand(tip, made);
  }
  for (int k = 0; shape.limbs == 0 && k < shape.hands; ++k) detail::add_hand(shape.trunk - k, made);
  return made;
}

}  // namespace treeline::tests
