#include <fmt/format.h>
#include <tinyxml2.h>

#include <array>
#include <string_view>

#include "description/parse_xml.hpp"
#include "description/read_robot_text.hpp"

namespace treeline {
namespace {

using tinyxml2::XMLElement;

struct Reference {
  std::string_view element, attribute;
};

/// Attributes that hold a name of the robot's own, or of a file beside its URDF.
constexpr std::array kReferences = {
    Reference{"link", "name"},     Reference{"joint", "name"},      Reference{"parent", "link"},
    Reference{"child", "link"},    Reference{"mimic", "joint"},     Reference{"material", "name"},
    Reference{"mesh", "filename"}, Reference{"drake:joint", "name"}};

void add_prefix(XMLElement& element, const std::string& prefix) {
  const std::string_view name = element.Name();
  for (const Reference& reference : kReferences) {
    const char* value = element.Attribute(reference.attribute.data());
    if (reference.element != name || value == nullptr || *value == '\0') continue;
    element.SetAttribute(reference.attribute.data(), (prefix + value).c_str());
  }
  for (XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    add_prefix(*child, prefix);
  }
}

bool is_shown(std::string_view element) {
  return element == "link" || element == "joint" || element == "material" ||
         element == "drake:joint";
}

/// Adds the world with a grain as its shape: programs draw sticks from links without a shape.
void add_world(XMLElement& all) {
  XMLElement* const world = all.InsertNewChildElement("link");
  world->SetAttribute("name", kWorldLink);
  world->InsertNewChildElement("visual")
      ->InsertNewChildElement("geometry")
      ->InsertNewChildElement("sphere")
      ->SetAttribute("radius", 0.001);
}

void add_base(const PlacedRobot& placed, XMLElement& all) {
  XMLElement* const joint = all.InsertNewChildElement("joint");
  joint->SetAttribute("name", placed.name.c_str());
  joint->SetAttribute("type", placed.base == Base::floating ? "floating" : "fixed");
  joint->InsertNewChildElement("parent")->SetAttribute("link", kWorldLink);
  const Link& root = placed.robot.links[static_cast<std::size_t>(placed.robot.root)];
  joint->InsertNewChildElement("child")->SetAttribute("link",
                                                      (placed.name + "/" + root.name).c_str());
  XMLElement* const origin = joint->InsertNewChildElement("origin");
  const auto& xyz = placed.pose.xyz;
  const auto& rpy = placed.pose.rpy;
  origin->SetAttribute("xyz", fmt::format("{} {} {}", xyz[0], xyz[1], xyz[2]).c_str());
  origin->SetAttribute("rpy", fmt::format("{} {} {}", rpy[0], rpy[1], rpy[2]).c_str());
}

}  // namespace

std::string print_joined_urdf(const SceneRobots& robots) {
  tinyxml2::XMLDocument joined;
  XMLElement* const all = joined.NewElement("robot");
  joined.InsertEndChild(all);
  all->SetAttribute("name", "robots");
  add_world(*all);
  for (std::size_t i = 0; i < robots.robots.size(); ++i) {
    const PlacedRobot& placed = robots.robots[i];
    add_base(placed, *all);
    tinyxml2::XMLDocument document;
    Diagnostics ignored;  // the file has been read before
    const InputFile& file = robots.files[robots.file_of_robot[i]];
    const XMLElement* robot = parse_urdf_xml(file.text, file.path, document, ignored);
    const XMLElement* child = robot == nullptr ? nullptr : robot->FirstChildElement();
    for (; child != nullptr; child = child->NextSiblingElement()) {
      if (!is_shown(child->Name())) continue;
      XMLElement* const copy = child->DeepClone(&joined)->ToElement();
      add_prefix(*copy, placed.name + "/");
      all->InsertEndChild(copy);
    }
  }
  tinyxml2::XMLPrinter printer;
  joined.Print(&printer);
  return printer.CStr();
}

}  // namespace treeline
