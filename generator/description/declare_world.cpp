#include "description/declare_world.hpp"

#include <string_view>

namespace treeline {
namespace {

using tinyxml2::XMLElement;

bool is_world(const XMLElement* element, const char* attribute) {
  const char* const name = element == nullptr ? nullptr : element->Attribute(attribute);
  return name != nullptr && std::string_view(name) == "world";
}

}  // namespace

void declare_world(XMLElement& robot, UrdfReading& reading) {
  const auto* link = robot.FirstChildElement("link");
  while (link != nullptr && !is_world(link, "name")) link = link->NextSiblingElement("link");
  const auto* joint = robot.FirstChildElement("joint");
  while (joint != nullptr && !is_world(joint->FirstChildElement("parent"), "link")) {
    joint = joint->NextSiblingElement("joint");
  }
  if (link != nullptr || joint == nullptr) return;
  robot.InsertNewChildElement("link")->SetAttribute("name", "world");
  reading.report(Severity::note, joint->GetLineNum(), "robot/joint",
                 "its parent is the link \"world\", which the file does not have: it is the ground",
                 "add <link name=\"world\"/> for other programs");
}

}  // namespace treeline
