#include <algorithm>

#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

bool has_inertia(const Link& link) {
  if (!link.inertial) return false;
  const Inertial& i = *link.inertial;
  return i.mass != 0 || i.ixx != 0 || i.iyy != 0 || i.izz != 0 || i.ixy != 0 || i.ixz != 0 ||
         i.iyz != 0;
}

/// Whether anything beyond each joint has inertia, by joint.
std::vector<bool> find_loaded(const Robot& robot) {
  std::vector<int> parent_joint(robot.links.size(), -1);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    parent_joint[static_cast<std::size_t>(robot.joints[j].child)] = static_cast<int>(j);
  }
  std::vector<bool> loaded(robot.joints.size(), false);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!has_inertia(robot.links[i])) continue;
    for (int j = parent_joint[i]; j >= 0;) {
      const auto joint = static_cast<std::size_t>(j);
      if (loaded[joint]) break;
      loaded[joint] = true;
      j = parent_joint[static_cast<std::size_t>(robot.joints[joint].parent)];
    }
  }
  return loaded;
}

void warn_of_heavy_world(const Robot& robot, const std::vector<UrdfElement>& elements) {
  const auto root = static_cast<std::size_t>(robot.root);
  if (robot.links[root].name != "world" || !has_inertia(robot.links[root])) return;
  elements[root].warn("the root link \"world\" has inertia; it counts only if the base floats",
                      "move the <inertial> to a link of the robot, or name this link otherwise");
}

}  // namespace

bool moves_inertia(const Robot& robot) {
  return std::any_of(robot.links.begin(), robot.links.end(), has_inertia);
}

std::vector<int> find_massless_joints(const Robot& robot) {
  std::vector<bool> loaded = find_loaded(robot);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const auto& mimic = robot.joints[j].mimic;
    if (mimic && loaded[j] && mimic->multiplier != 0) {
      loaded[static_cast<std::size_t>(mimic->joint)] = true;
    }
  }
  std::vector<int> massless;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const bool moves = info_of(robot.joints[j].type).moves() && !robot.joints[j].mimic;
    if (moves && !loaded[j]) massless.push_back(static_cast<int>(j));
  }
  return massless;
}

void check_motion(const Robot& robot, const std::vector<UrdfElement>& elements,
                  UrdfReading& reading) {
  warn_of_heavy_world(robot, elements);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const auto& xml = elements[i].xml();
    const bool shaped = xml.FirstChildElement("visual") || xml.FirstChildElement("collision");
    if (robot.links[i].inertial || !shaped || static_cast<int>(i) == robot.root) continue;
    reading.pass_over(Severity::warning, "shape without inertial", elements[i].line(),
                      elements[i].path(), "the link has a shape but no <inertial>; it is massless",
                      "add <inertial> if the link has mass");
  }
}

}  // namespace treeline
