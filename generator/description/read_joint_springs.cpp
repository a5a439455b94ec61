#include <fmt/format.h>

#include <optional>
#include <string>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"

namespace treeline {
namespace {

bool can_have_spring(const SceneElement& value, const Joint& joint, const Scene& scene) {
  if (scene.locked.contains(joint.name)) {
    value.error("the joint is locked", "remove this line");
  } else if (!info_of(joint.type).has_one_freedom()) {
    value.error("the joint has not one degree of freedom", "remove this line");
  } else if (joint.mimic && joint.mimic->multiplier == 0) {
    value.error("the joint follows with multiplier 0 and rests", "remove this line");
  } else {
    return true;
  }
  return false;
}

std::optional<SceneSpring> read_spring(const SceneElement& value, const Joint& joint) {
  const auto fields = value.fields({"stiffness", "rest"});
  const auto stiffness = fields.find("stiffness");
  if (stiffness == fields.end()) {
    value.error("the key \"stiffness\" is missing", "give it, N m/rad or N/m");
    return std::nullopt;
  }
  SceneSpring spring;
  spring.stiffness = stiffness->second.number().value_or(1);
  if (!(spring.stiffness > 0)) {
    stiffness->second.error(fmt::format("{} is not positive", spring.stiffness),
                            "a spring pulls towards its rest");
    return std::nullopt;
  }
  if (const auto rest = fields.find("rest"); rest != fields.end()) {
    spring.rest = rest->second.number(!info_of(joint.type).slides()).value_or(0);
  }
  return spring;
}

}  // namespace

void read_joint_springs(const SceneElement& element, const Robot& robot, Scene& scene) {
  for (const auto& [name, value] : element.entries("write joint: {stiffness: N m/rad}")) {
    if (name == "implicit" && !value.is_map()) {
      scene.implicit_friction = value.choice({"false", "true"}) == 1 || scene.implicit_friction;
      continue;
    }
    const Joint* const joint = find_joint(value, name, robot);
    if (joint == nullptr || !can_have_spring(value, *joint, scene)) continue;
    if (const auto spring = read_spring(value, *joint)) scene.joint_springs[name] = *spring;
  }
}

void note_unused_springs(const SceneElement& top, const Robot& robot) {
  if (robot.hints.springs.empty()) return;
  top.note(fmt::format("the robot's file states springs of {} joints; no function counts them",
                       robot.hints.springs.size()),
           "`treeline init-scene` writes them as joint_springs");
}

}  // namespace treeline
