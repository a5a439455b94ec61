#pragma once

#include <string>
#include <utility>
#include <vector>

#include "description/join_robots.hpp"
#include "random_mechanism.hpp"

/// Several robots with scenes of their own, joined in one scene.
namespace treeline::tests {

/// One of them: it stands at a pose that is turned about z only, so that gravity along z is the
/// same for it as for the robot alone.
struct PlacedMechanism {
  RandomMechanism made;
  Pose pose;  ///< identity for a floating base
};

inline std::string part_name(std::size_t i) {
  return "robot" + std::to_string(i);
}

template <class Value>
void add_renamed(const std::map<std::string, Value>& from, const std::string& prefix,
                 std::map<std::string, Value>& to) {
  for (const auto& [name, value] : from) to[prefix + name] = value;
}

/// What one robot's scene says, in the names of the joined one.
inline void add_scene(const Scene& from, const std::string& part, Scene& to) {
  const std::string prefix = part + "/";
  for (auto points : {&Scene::operational_points, &Scene::external_forces}) {
    for (ScenePoint point : from.*points) {
      point.name.insert(0, part + "_");
      point.link.insert(0, prefix);
      (to.*points).push_back(std::move(point));
    }
  }
  add_renamed(from.locked, prefix, to.locked);
  add_renamed(from.armature, prefix, to.armature);
  add_renamed(from.joint_friction, prefix, to.joint_friction);
  add_renamed(from.joint_springs, prefix, to.joint_springs);
}

inline RandomMechanism joined(const std::vector<PlacedMechanism>& parts) {
  RandomMechanism all;
  all.scene = parts.front().made.scene;
  all.scene.base = Base::fixed;
  for (auto points : {&Scene::operational_points, &Scene::external_forces}) {
    (all.scene.*points).clear();
  }
  all.scene.locked.clear();
  all.scene.armature.clear();
  all.scene.joint_friction.clear();
  all.scene.joint_springs.clear();
  std::vector<PlacedRobot> robots;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [made, pose] = parts[i];
    robots.push_back({part_name(i), made.robot, made.scene.base, pose});
    add_scene(made.scene, part_name(i), all.scene);
  }
  all.robot = join_robots(robots, "joined");
  return all;
}

}  // namespace treeline::tests
