#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"
#include "description/robot_queries.hpp"
#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

const char* const kRemedyOfArmature =
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
    element.error("the robot's file states no rotor's inertia",
                  "give inertias at the joints, lines of the form joint: kg m^2 or kg");
  }
}

/// The rotor's own inertia and the gear ratio.
std::optional<SceneRotor> read_rotor(const SceneElement& value, const SceneFields& fields,
                                     const Joint& joint) {
  const auto inertia = fields.find("rotor_inertia");
  if (inertia == fields.end()) {
    value.error("the key \"rotor_inertia\" is missing", "give it, kg m^2 about the motor's axis");
    return std::nullopt;
  }
  SceneRotor rotor;
  rotor.ratio = joint.rotor ? joint.rotor->ratio : 1;
  if (const auto gear = fields.find("gear_ratio"); gear != fields.end()) {
    rotor.ratio = gear->second.number().value_or(1);
    if (rotor.ratio == 0) {
      gear->second.error("0 is no ratio", "write it in turns of the rotor for one of the joint");
      return std::nullopt;
    }
  }
  const auto own = inertia->second.number();
  if (!own) return std::nullopt;
  rotor.inertia = *own;
  return rotor;
}

/// Sets link and axis of a rotor that is a body of its own: it sits on the link before its joint,
/// or where the scene says.
bool place_rotor(const SceneFields& fields, const Robot& robot, SceneRotor& rotor) {
  if (const auto link = fields.find("link"); link != fields.end()) {
    const auto name = link->second.text();
    if (!name) return false;
    rotor.link = *name;
    if (std::none_of(robot.links.begin(), robot.links.end(),
                     [&](const Link& each) { return each.name == *name; })) {
      link->second.error(fmt::format("the robot has no link \"{}\"", *name),
                         suggest_link(*name, robot));
      return false;
    }
    if (!fields.contains("axis")) {
      link->second.error("the rotor's axis is missing", "give axis: [x, y, z] in the link's axes");
      return false;
    }
  }
  const auto axis = fields.find("axis");
  if (axis == fields.end()) return true;
  std::array<double, 3> direction{};
  const auto items = axis->second.items();
  for (std::size_t i = 0; i < direction.size() && i < items.size(); ++i) {
    direction[i] = items[i].number().value_or(0);
  }
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (items.size() != 3 || !(length > 0)) {
    axis->second.error("the axis has no direction", "give three numbers, [0, 0, 1] for z");
    return false;
  }
  for (double& each : direction) each /= length;
  rotor.axis = direction;
  return true;
}

/// Reads the rotor that the scene states for a joint: its inertia alone, or a map.
void read_line(const SceneElement& value, const Joint& joint, const Robot& robot, Scene& scene) {
  SceneRotor rotor;
  bool gyroscopic = false;
  if (value.is_map()) {
    const SceneFields fields =
        value.fields({"rotor_inertia", "gear_ratio", "gyroscopic", "link", "axis"});
    const auto read = read_rotor(value, fields, joint);
    if (!read) return;
    rotor = *read;
    if (const auto asked = fields.find("gyroscopic"); asked != fields.end()) {
      gyroscopic = asked->second.choice({"false", "true"}) == 1;
    }
    for (const char* key : {"link", "axis"}) {
      const auto found = fields.find(key);
      if (gyroscopic || found == fields.end()) continue;
      found->second.error("where a rotor sits matters to its gyroscopic moments alone",
                          "write gyroscopic: true, or remove this");
      return;
    }
    if (!place_rotor(fields, robot, rotor)) return;
  } else {
    const auto number = value.number();
    if (!number) return;
    rotor.inertia = *number;
  }
  if (rotor.inertia < 0) {
    value.error(fmt::format("{} is negative", rotor.inertia), "an inertia is not below 0");
  } else if (!can_carry_rotor(joint, scene)) {
    value.error(scene.locked.contains(joint.name) ? "the joint is locked"
                                                  : "the joint has not one degree of freedom",
                "remove this line");
  } else if (const double reflected = rotor.inertia * rotor.ratio * rotor.ratio; reflected > 0) {
    gyroscopic ? static_cast<void>(scene.rotors.emplace(joint.name, rotor))
               : static_cast<void>(scene.armature.emplace(joint.name, reflected));
  }
}

}  // namespace

void read_armature(const SceneElement& element, const Robot& robot, Scene& scene) {
  if (element.is("none")) return;
  if (element.is("file")) return take_from_file(element, robot, scene);
  for (const auto& [name, value] : element.entries(kRemedyOfArmature)) {
    const Joint* joint = find_joint(value, name, robot);
    if (joint != nullptr) read_line(value, *joint, robot, scene);
  }
}

void note_unused_rotors(const SceneElement& top, const Robot& robot) {
  const auto stated = std::count_if(robot.joints.begin(), robot.joints.end(),
                                    [](const Joint& each) { return armature_of(each) > 0; });
  if (stated == 0) return;
  top.note(
      fmt::format("the robot's file states rotors of {} joints; no function counts them", stated),
      "armature: file in the scene adds their inertia to the joints'");
}

}  // namespace treeline
