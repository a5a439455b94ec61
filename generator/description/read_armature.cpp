#include "description/read_armature.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/read_rotors.hpp"
#include "description/read_scene_point.hpp"

namespace treeline {
namespace {

const char* const kRemedy =
    "write `file`, `none`, or lines of the form joint: inertia at the joint, kg m^2 or kg";

bool can_carry_rotor(const Joint& joint, const Scene& scene) {
  return info_of(joint.type).has_one_freedom() && !scene.locked.contains(joint.name);
}

void take_from_file(const SceneElement& element, const Robot& robot, Scene& scene) {
  for (const Joint& joint : robot.joints) {
    const double armature = armature_of(joint);
    if (armature > 0 && can_carry_rotor(joint, scene)) scene.armature.emplace(joint.name, armature);
  }
  if (scene.armature.empty()) {
    element.error("the URDF states no rotor's inertia",
                  "give inertias at the joints, lines of the form joint: kg m^2 or kg");
  }
}

/// A number is the inertia at the joint; a map has the rotor's own and the gear ratio.
std::optional<double> read_inertia(const SceneElement& value, const Joint& joint) {
  if (!value.is_map()) return value.number();
  const auto fields = value.fields({"rotor_inertia", "gear_ratio"});
  const auto inertia = fields.find("rotor_inertia");
  if (inertia == fields.end()) {
    value.error("the key \"rotor_inertia\" is missing", "give it, kg m^2 about the motor's axis");
    return std::nullopt;
  }
  double ratio = joint.rotor ? joint.rotor->ratio : 1;
  if (const auto gear = fields.find("gear_ratio"); gear != fields.end()) {
    ratio = gear->second.number().value_or(1);
  }
  const auto own = inertia->second.number();
  return own ? std::optional<double>(*own * ratio * ratio) : std::nullopt;
}

}  // namespace

void read_armature(const SceneElement& element, const Robot& robot, Scene& scene) {
  if (element.is("none")) return;
  if (element.is("file")) return take_from_file(element, robot, scene);
  for (const auto& [name, value] : element.entries(kRemedy)) {
    const Joint* joint = find_joint(value, name, robot);
    if (joint == nullptr) continue;
    const auto inertia = read_inertia(value, *joint);
    if (!inertia) continue;
    if (*inertia < 0) {
      value.error(fmt::format("{} is negative", *inertia), "an inertia is not below 0");
    } else if (!can_carry_rotor(*joint, scene)) {
      value.error(scene.locked.contains(name) ? "the joint is locked"
                                              : "the joint has not one degree of freedom",
                  "remove this line");
    } else if (*inertia > 0) {
      scene.armature.emplace(name, *inertia);
    }
  }
}

void note_unused_rotors(const SceneElement& top, const Robot& robot) {
  const auto stated = std::count_if(robot.joints.begin(), robot.joints.end(),
                                    [](const Joint& each) { return armature_of(each) > 0; });
  if (stated == 0) return;
  top.note(fmt::format("the URDF states rotors of {} joints; no function counts them", stated),
           "armature: file in the scene adds their inertia to the joints'");
}

}  // namespace treeline
