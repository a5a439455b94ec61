#include <fmt/format.h>

#include <algorithm>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"

namespace treeline {
namespace {

bool is_passive(const Scene& scene, const Joint& joint) {
  return std::count(scene.passive.begin(), scene.passive.end(), joint.name) > 0;
}

/// Joints that have a motor of their own, with the efforts that the robot's file states.
void take_efforts(const SceneElement& element, const Robot& robot, Scene& scene) {
  for (const Joint& joint : robot.joints) {
    if (joint.mimic || scene.locked.contains(joint.name) || is_passive(scene, joint)) continue;
    if (!info_of(joint.type).has_one_freedom() || !joint.limits) continue;
    const Limit& effort = joint.limits->effort;
    if (effort.is_stated()) scene.torque_limits[joint.name] = effort;
  }
  scene.torque_limits_of_urdf = true;
  if (!scene.torque_limits.empty()) return;
  element.error("the robot's file states no effort of any joint with a motor",
                "write torque_limits: {joint: N m}, or the effort in the robot's file");
}

void read_limit(const std::string& name, const SceneElement& value, const Joint& joint,
                Scene& scene) {
  const auto most = value.number();
  if (joint.mimic) {
    value.error("a joint that mimics has no motor of its own", "limit the joint that it follows");
  } else if (scene.locked.contains(name) || !info_of(joint.type).has_one_freedom()) {
    value.error("only a joint that moves in one degree of freedom has a motor", "remove this line");
  } else if (is_passive(scene, joint)) {
    value.error("the joint is passive, without a motor", "remove this line");
  } else if (most && !(*most > 0)) {
    value.error(fmt::format("{} is not positive", *most), "give the largest torque, N m or N");
  } else if (most) {
    scene.torque_limits[name] = *most;
  }
}

}  // namespace

void read_torque_limits(const SceneElement& element, const Robot& robot, Scene& scene) {
  if (element.is("urdf")) {
    take_efforts(element, robot, scene);
    return;
  }
  if (!element.is_map()) {
    element.error("neither `urdf` nor a map is given",
                  "write urdf for the efforts of the URDF, or {joint: N m}");
    return;
  }
  const auto entries = element.entries("write lines joint: N m");
  if (entries.empty()) element.error("no joint is listed", "write {joint: N m}, or urdf");
  for (const auto& [name, value] : entries) {
    const Joint* const joint = find_joint(value, name, robot);
    if (joint != nullptr) read_limit(name, value, *joint, scene);
  }
}

}  // namespace treeline
