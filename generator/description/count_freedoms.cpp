#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "description/scene_queries.hpp"

namespace treeline {
namespace {

/// Adds the coordinate that a joint moves with, if it moves.
void add_owner(const Robot& robot, const Scene& scene, int joint, Freedoms& freedoms) {
  const auto& mimic = robot.joints[static_cast<std::size_t>(joint)].mimic;
  const int owner = mimic ? mimic->joint : joint;
  const Joint& moving = robot.joints[static_cast<std::size_t>(owner)];
  if (!info_of(moving.type).moves() || scene.locked.contains(moving.name)) return;
  freedoms.emplace(owner, info_of(moving.type).freedoms());
}

/// The joints from the root to a link.
std::set<int> joints_above(const Robot& robot, const std::string& link) {
  std::vector<int> parent_joint(robot.links.size(), -1);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    parent_joint[static_cast<std::size_t>(robot.joints[i].child)] = static_cast<int>(i);
  }
  std::set<int> above;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].name != link) continue;
    for (int joint = parent_joint[i]; joint >= 0;) {
      above.insert(joint);
      const int parent = robot.joints[static_cast<std::size_t>(joint)].parent;
      joint = parent_joint[static_cast<std::size_t>(parent)];
    }
  }
  return above;
}

Freedoms base_freedoms(const Scene& scene) {
  if (scene.base == Base::floating) return {{kFloatingBase, 6}};
  return {};
}

}  // namespace

int count(const Freedoms& freedoms) {
  int sum = 0;
  for (const auto& [owner, number] : freedoms) sum += number;
  return sum;
}

Freedoms find_freedoms(const Robot& robot, const Scene& scene) {
  Freedoms freedoms = base_freedoms(scene);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    add_owner(robot, scene, static_cast<int>(i), freedoms);
  }
  return freedoms;
}

Freedoms find_freedoms_of_link(const Robot& robot, const Scene& scene, const std::string& link) {
  Freedoms freedoms = base_freedoms(scene);
  for (const int joint : joints_above(robot, link)) add_owner(robot, scene, joint, freedoms);
  return freedoms;
}

Freedoms find_freedoms_of(const Robot& robot, const Scene& scene, const ScenePoint& point) {
  return point.center_of_mass ? find_freedoms(robot, scene)
                              : find_freedoms_of_link(robot, scene, point.link);
}

bool moves_against(const Robot& robot, const Scene& scene, const std::string& link,
                   const std::string& other) {
  const std::set<int> above = joints_above(robot, link);
  const std::set<int> above_other = joints_above(robot, other);
  std::vector<int> between;
  std::set_symmetric_difference(above.begin(), above.end(), above_other.begin(), above_other.end(),
                                std::back_inserter(between));
  Freedoms freedoms;
  for (const int joint : between) add_owner(robot, scene, joint, freedoms);
  return !freedoms.empty();
}

}  // namespace treeline
