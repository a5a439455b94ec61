#pragma once

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

/// Robots of a few joints, written down joint by joint.
namespace treeline::tests {

struct SampleJoint {
  std::string name;
  std::string parent;  ///< link; the joint NAME carries the link NAME_link
  JointType type = JointType::revolute;
  std::array<double, 3> axis{0, 0, 1};
  Pose origin{};
};

inline int index_of_link(const Robot& robot, const std::string& name) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].name == name) return static_cast<int>(i);
  }
  throw std::logic_error("no link " + name);
}

inline Joint& joint_named(Robot& robot, const std::string& name) {
  for (Joint& joint : robot.joints) {
    if (joint.name == name) return joint;
  }
  throw std::logic_error("no joint " + name);
}

/// A body without symmetry: nothing about it is aligned.
inline Inertial sample_inertial(int which) {
  Inertial inertial;
  inertial.mass = 1 + which;
  inertial.origin = {{0.1, -0.05 * which, 0.2}, {0.3, 0.1 * which, -0.4}};
  inertial.ixx = 0.05;
  inertial.iyy = 0.06;
  inertial.izz = 0.04;
  inertial.ixy = 0.01;
  inertial.ixz = -0.005;
  inertial.iyz = 0.002;
  return inertial;
}

/// Links `base` and one per joint, each with mass. The joints are in the given order, as in a file.
inline Robot sample_robot(const std::vector<SampleJoint>& joints) {
  Robot robot;
  robot.name = "sample";
  robot.root = 0;
  robot.links.push_back({"base", sample_inertial(0), 0});
  for (const SampleJoint& from : joints) {
    robot.links.push_back(
        {from.name + "_link", sample_inertial(static_cast<int>(robot.links.size())), 0});
  }
  for (const SampleJoint& from : joints) {
    Joint joint;
    joint.name = from.name;
    joint.type = from.type;
    joint.parent = index_of_link(robot, from.parent);
    joint.child = index_of_link(robot, from.name + "_link");
    joint.origin = from.origin;
    joint.axis = from.axis;
    robot.joints.push_back(joint);
  }
  return robot;
}

inline ScenePoint sample_point(const std::string& link) {
  ScenePoint point;
  point.name = point.link = link;
  point.origin = {{0.1, 0.2, -0.3}, {0.5, -0.25, 0.125}};
  return point;
}

/// Counts the numbers of an inertia that are not zero. A symmetric matrix has six.
inline int count_inertia_numbers(const Inertia& inertia) {
  int count = inertia.mass != 0 ? 1 : 0;
  for (int i = 0; i < 3; ++i) {
    count += inertia.h(i) != 0 ? 1 : 0;
    for (int j = i; j < 3; ++j) count += inertia.Sigma(i, j) != 0 ? 1 : 0;
  }
  return count;
}

}  // namespace treeline::tests
