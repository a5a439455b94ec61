#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "description/urdf_parts.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

JointType read_type(const UrdfElement& element) {
  std::vector<std::string> names;
  for (const JointTypeInfo& row : kJointTypes) names.emplace_back(row.name);
  const auto text = element.required_text("type", "give a type: " + list_names(names));
  if (!text) return JointType::fixed;
  if (const JointTypeInfo* found = find_joint_type(*text)) return found->type;
  element.error(fmt::format("\"{}\" is not a joint type of URDF", *text),
                suggest_name(*text, names, "the types are"));
  return JointType::fixed;
}

std::string read_end(const UrdfElement& element, const char* end) {
  const std::string remedy = fmt::format("write <{} link=\"NAME\"/>", end);
  const auto found = element.child(end);
  if (!found) {
    element.error(fmt::format("the joint has no <{}>", end), remedy);
    return {};
  }
  if (const auto* second = found->xml().NextSiblingElement(end)) {
    element.as_child(*second).error(fmt::format("the joint has two <{}>", end), "keep one");
  }
  found->holds_only_attributes({"link"});
  return found->required_text("link", remedy).value_or("");
}

}  // namespace

std::array<double, 3> read_axis(const UrdfElement& joint, const char* name) {
  const std::array<double, 3> by_default{1, 0, 0};
  const auto element = joint.child(name);
  if (!element) return by_default;
  element->holds_only_attributes({"xyz"});
  if (!element->required_text("xyz",
                              "write <axis xyz=\"0 0 1\"/>, or remove <axis>: then it is x")) {
    return by_default;
  }
  auto axis = element->three_numbers("xyz");
  if (!axis) return by_default;
  double largest = 0;
  for (const double component : *axis) largest = std::max(largest, std::abs(component));
  if (largest == 0) {
    element->error("the axis is zero",
                   "give the direction of the joint's axis in the joint's frame");
    return by_default;
  }
  // Scaled by the largest component, so that the square neither overflows nor vanishes.
  double square = 0;
  for (double& component : *axis) {
    component /= largest;
    square += component * component;
  }
  const double length = std::sqrt(square);
  for (double& component : *axis) component /= length;
  if (std::abs(length * largest - 1) > 1e-2) {
    element->reading().pass_over(
        Severity::note, "joint/axis length", element->line(), element->path(),
        fmt::format("the axis has length {:.6g} and is made a unit vector", length * largest), "");
  }
  return *axis;
}

namespace {

/// Warns of `<axis>` and `<limit>` in a joint that URDF does not define. They have no meaning
/// there: programs write them because other programs want them.
void ignore_axis_and_limits(const UrdfElement& joint, const JointTypeInfo& type) {
  for (const char* name : {"axis", "limit"}) {
    const auto element = joint.child(name);
    if (!element) continue;
    element->warn(fmt::format("<{}> has no meaning for a {} joint and is ignored", name, type.name),
                  "remove it");
  }
}

void read_dynamics(const UrdfElement& joint, Joint& result) {
  const auto element = joint.child("dynamics");
  if (!element) return;
  element->holds_only_attributes({"damping", "friction", "armature"});
  if (const auto armature = element->number("armature")) {
    if (*armature < 0) {
      element->error(fmt::format("armature={} is negative", *armature), "give a positive one");
    } else {
      result.rotor = Rotor{*armature, 1};
    }
  } else if (!element->has("damping") && !element->has("friction")) {
    element->warn("there is neither \"damping\" nor \"friction\"", "remove <dynamics>",
                  Minor::form);
  }
  result.damping = element->number("damping").value_or(0);
  result.friction = element->number("friction").value_or(0);
  for (const auto& [name, value] :
       {std::pair{"damping", result.damping}, {"friction", result.friction}}) {
    if (value < 0) {
      element->warn(fmt::format("{}={} is negative", name, value), "give a positive one",
                    Minor::form);
    }
  }
}

void read_mimic(const UrdfElement& joint, NamedJoint& result) {
  const auto element = joint.child("mimic");
  if (!element) return;
  if (!info_of(result.joint.type).has_axis) {
    element->reading().pass_over(Severity::warning, "joint/mimic", element->line(), element->path(),
                                 fmt::format("a {} joint cannot mimic; <mimic> is ignored",
                                             joint_type_name(result.joint.type)),
                                 "remove it");
    return;
  }
  element->holds_only_attributes({"joint", "multiplier", "offset"});
  if (!info_of(result.joint.type).has_one_freedom()) {
    element->error("only a joint of one degree of freedom can mimic", "remove <mimic>");
  }
  Mimic mimic;
  mimic.multiplier = element->number("multiplier").value_or(1);
  mimic.offset = element->number("offset").value_or(0);
  result.mimicked = element->required_text("joint", "write <mimic joint=\"NAME\"/>").value_or("");
  result.joint.mimic = mimic;
  if (mimic.multiplier == 0) {
    element->warn("multiplier=0: the joint rests at its offset", "make the joint fixed");
  }
}

}  // namespace

NamedJoint read_joint(const UrdfElement& element) {
  NamedJoint result{{}, {}, {}, {}, element};
  Joint& joint = result.joint;
  joint.line = element.line();
  joint.name = element.required_name("give the joint a name");
  element.only_attributes({"name", "type"});
  element.only_children({"origin", "parent", "child", "axis", "limit", "dynamics", "mimic",
                         "calibration", "safety_controller"});
  joint.type = read_type(element);
  result.parent = read_end(element, "parent");
  result.child = read_end(element, "child");
  joint.origin = element.origin();
  const JointTypeInfo& type = info_of(joint.type);
  if (type.has_axis) joint.axis = read_axis(element);
  if (const auto* axis = element.xml().FirstChildElement("axis")) {
    joint.axis_line = axis->GetLineNum();
  }
  if (!type.is_standard) ignore_axis_and_limits(element, type);
  if (type.is_standard && type.moves()) joint.limits = read_joint_limits(element, joint.type);
  read_dynamics(element, joint);
  read_mimic(element, result);
  return result;
}

}  // namespace treeline
