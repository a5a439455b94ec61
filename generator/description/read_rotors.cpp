#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "description/read_number.hpp"
#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

/// Elements that state a rotor's inertia, in the order in which they count.
constexpr std::array kInertias = {"drake:rotor_inertia", "rotorInertia", "motorInertia"};

int count_children(const UrdfElement& element, const char* name) {
  int count = 0;
  const auto* xml = element.xml().FirstChildElement(name);
  for (; xml != nullptr; xml = xml->NextSiblingElement(name)) ++count;
  return count;
}

/// The number that is the element's text, or its attribute `value`.
std::optional<double> read_value(const UrdfElement& element) {
  if (element.has("value")) return element.number("value");
  const char* const text = element.xml().GetText();
  const auto value = text != nullptr ? read_number(text) : std::nullopt;
  if (!value) {
    element.warn(fmt::format("<{}> holds no number and is ignored", element.name()),
                 "write one, or remove it", Minor::form);
  }
  return value;
}

/// Finds a value in a child of the joint, the motor or the transmission, in this order.
std::optional<double> find_value(const std::vector<UrdfElement>& places, const char* name) {
  for (const UrdfElement& place : places) {
    if (const auto found = place.child(name)) return read_value(*found);
  }
  return std::nullopt;
}

void read_rotor(const UrdfElement& transmission, Joint& joint) {
  std::vector<UrdfElement> places{*transmission.child("joint")};
  if (const auto motor = transmission.child("actuator")) places.push_back(*motor);
  places.push_back(transmission);
  const auto gear = find_value(places, "drake:gear_ratio");
  const auto ratio = gear ? gear : find_value(places, "mechanicalReduction");
  std::optional<double> inertia;
  for (const char* name : kInertias) {
    if (!inertia) inertia = find_value(places, name);
  }
  if (inertia && *inertia < 0) {
    transmission.error(fmt::format("the rotor's inertia {} is negative", *inertia),
                       "give a positive one, kg m^2");
    return;
  }
  if (ratio && *ratio == 0) {
    transmission.warn("the gear ratio is 0 and is ignored",
                      "give turns of the rotor for one of the joint");
    return;
  }
  if (!ratio && !inertia) return;
  if (!joint.rotor) joint.rotor = Rotor{};
  if (ratio && !joint.rotor->inertia) joint.rotor->ratio = *ratio;
  if (inertia && !joint.rotor->inertia) joint.rotor->inertia = inertia;
}

/// Warns if one of several motors has a rotor. Without one, a differential says nothing of inertia.
void warn_of_coupling(const UrdfElement& transmission) {
  const auto* motor = transmission.xml().FirstChildElement("actuator");
  const auto has_rotor = [](const tinyxml2::XMLElement& element) {
    return std::any_of(kInertias.begin(), kInertias.end(), [&](const char* name) {
      return element.FirstChildElement(name) != nullptr;
    });
  };
  while (motor != nullptr && !has_rotor(*motor)) {
    motor = motor->NextSiblingElement("actuator");
  }
  if (motor == nullptr) return;
  transmission.warn(
      "a <transmission> of several joints or motors couples them; its rotors are "
      "passed over",
      "give armatures of single joints in the scene");
}

}  // namespace

void read_rotors(const UrdfElement& robot, std::vector<Joint>& joints) {
  const char* const kName = "transmission";
  const auto* xml = robot.xml().FirstChildElement(kName);
  for (; xml != nullptr; xml = xml->NextSiblingElement(kName)) {
    const UrdfElement transmission = robot.as_child(*xml);
    if (count_children(transmission, "joint") != 1 ||
        count_children(transmission, "actuator") > 1) {
      warn_of_coupling(transmission);
      continue;
    }
    const auto driven = transmission.child("joint");
    const char* const name = driven->xml().Attribute("name");
    const auto joint = std::find_if(joints.begin(), joints.end(), [&](const Joint& each) {
      return name != nullptr && each.name == name;
    });
    if (joint != joints.end()) read_rotor(transmission, *joint);
  }
}

double armature_of(const Joint& joint) {
  if (!joint.rotor) return 0;
  return joint.rotor->inertia.value_or(0) * joint.rotor->ratio * joint.rotor->ratio;
}

}  // namespace treeline
