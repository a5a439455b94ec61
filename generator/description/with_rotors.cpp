#include "description/with_rotors.hpp"

#include <algorithm>

#include "description/robot_queries.hpp"

namespace treeline {
namespace {

bool has_name(const Robot& robot, const std::string& name) {
  const auto is = [&](const auto& each) { return each.name == name; };
  return std::any_of(robot.links.begin(), robot.links.end(), is) ||
         std::any_of(robot.joints.begin(), robot.joints.end(), is);
}

/// A moment about the axis alone.
Inertial moment_about(const std::array<double, 3>& axis, double inertia) {
  const auto& [x, y, z] = axis;
  Inertial inertial;
  inertial.ixx = inertia * x * x;
  inertial.ixy = inertia * x * y;
  inertial.ixz = inertia * x * z;
  inertial.iyy = inertia * y * y;
  inertial.iyz = inertia * y * z;
  inertial.izz = inertia * z * z;
  return inertial;
}

void add_rotor(std::size_t driven, const SceneRotor& rotor, Robot& robot) {
  const Joint& joint = robot.joints[driven];
  Joint turning;
  turning.name = joint.name + "_rotor";
  while (has_name(robot, turning.name)) turning.name += "_";
  turning.type = JointType::continuous;
  turning.parent =
      rotor.link.empty() ? joint.parent : static_cast<int>(index_of_link(robot, rotor.link));
  turning.child = static_cast<int>(robot.links.size());
  turning.axis = rotor.axis.value_or(joint.axis);
  if (!rotor.axis) turning.origin = joint.origin;
  turning.mimic = joint.mimic.value_or(Mimic{static_cast<int>(driven), 1, 0});
  turning.mimic->multiplier *= rotor.ratio;
  turning.mimic->offset = 0;
  turning.spins = true;
  turning.line = joint.line;
  robot.links.push_back({turning.name, moment_about(turning.axis, rotor.inertia), joint.line});
  robot.joints.push_back(std::move(turning));
}

}  // namespace

Robot with_rotors(Robot robot, const Scene& scene) {
  const std::size_t joints = robot.joints.size();
  for (std::size_t j = 0; j < joints; ++j) {
    const auto found = scene.rotors.find(robot.joints[j].name);
    if (found != scene.rotors.end()) add_rotor(j, found->second, robot);
  }
  return robot;
}

}  // namespace treeline
