#include "launch/split_ball_joints.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "description/join_robots.hpp"

namespace treeline {
namespace {

constexpr std::array kAxisNames = {"x", "y", "z"};
constexpr double kMostOfMiddle = 1.4;  // rad: 80 degrees, where two axes are nearly one

/// The hinge about axis `i` in place of the ball joint `ball`.
Joint hinge_of(const Joint& ball, std::size_t i) {
  Joint hinge;
  hinge.name = ball.name + "." + kAxisNames[i];
  hinge.axis = {};
  hinge.axis[i] = 1;
  hinge.line = ball.line;
  hinge.type = i == 1 ? JointType::revolute : JointType::continuous;
  if (i == 1) hinge.limits = Limits{-kMostOfMiddle, kMostOfMiddle};
  return hinge;
}

void split(Robot& robot, std::size_t at) {
  const Joint ball = robot.joints[at];
  std::array<Joint, 3> hinges = {hinge_of(ball, 0), hinge_of(ball, 1), hinge_of(ball, 2)};
  hinges[0].origin = ball.origin;
  hinges[0].parent = ball.parent;
  for (std::size_t i = 0; i < 2; ++i) {
    hinges[i].child = hinges[i + 1].parent = static_cast<int>(robot.links.size());
    robot.links.push_back({hinges[i].name, std::nullopt, ball.line});
  }
  hinges[2].child = ball.child;
  robot.joints[at] = hinges[0];
  robot.joints.insert(robot.joints.end(), hinges.begin() + 1, hinges.end());
}

/// A joint without a motor has none about any axis.
void rename(std::vector<std::string>& joints, const std::string& ball) {
  const auto found = std::find(joints.begin(), joints.end(), ball);
  if (found == joints.end()) return;
  joints.erase(found);
  for (const char* axis : kAxisNames) joints.push_back(ball + "." + axis);
}

bool is_ball(const tinyxml2::XMLElement& element) {
  const std::string_view name = element.Name();
  const char* type = element.Attribute("type");
  if (type == nullptr || (name != "joint" && name != "drake:joint")) return false;
  const JointTypeInfo* info = find_joint_type(type);
  return info != nullptr && info->type == JointType::ball;
}

tinyxml2::XMLElement& add_child(tinyxml2::XMLElement& parent, const char* name,
                                const char* attribute, const std::string& value) {
  tinyxml2::XMLElement* child = parent.InsertNewChildElement(name);
  child->SetAttribute(attribute, value.c_str());
  return *child;
}

const char* link_of(const tinyxml2::XMLElement& joint, const char* end) {
  const tinyxml2::XMLElement* element = joint.FirstChildElement(end);
  const char* link = element != nullptr ? element->Attribute("link") : nullptr;
  return link != nullptr ? link : "";
}

/// Appends the hinges in place of `ball` to the robot, and links between them.
void append_hinges(tinyxml2::XMLElement& robot, const tinyxml2::XMLElement& ball) {
  const char* const given = ball.Attribute("name");
  const std::string name = given != nullptr ? given : "";
  std::string parent = link_of(ball, "parent");
  for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
    const std::string hinge = name + "." + kAxisNames[i];
    const std::string child = i < 2 ? hinge : link_of(ball, "child");
    if (i < 2) add_child(robot, "link", "name", hinge);
    tinyxml2::XMLElement& joint = add_child(robot, "joint", "name", hinge);
    joint.SetAttribute("type", i == 1 ? "revolute" : "continuous");
    add_child(joint, "parent", "link", parent);
    add_child(joint, "child", "link", child);
    add_child(joint, "axis", "xyz", std::array{"1 0 0", "0 1 0", "0 0 1"}[i]);
    if (i == 1) {
      add_child(joint, "limit", "lower", fmt::format("{}", -kMostOfMiddle))
          .SetAttribute("upper", kMostOfMiddle);
    }
    const tinyxml2::XMLElement* origin = ball.FirstChildElement("origin");
    if (i == 0 && origin != nullptr) joint.InsertEndChild(origin->DeepClone(joint.GetDocument()));
    parent = hinge;
  }
}

}  // namespace

void split_ball_joints(Robot& robot, Scene& scene, Diagnostics& diagnostics) {
  const std::size_t joints = robot.joints.size();
  for (std::size_t i = 0; i < joints; ++i) {
    if (robot.joints[i].type != JointType::ball) continue;
    const Joint ball = robot.joints[i];
    split(robot, i);
    rename(scene.passive, ball.name);
    diagnostics.add(
        {Severity::note, file_of(robot, ball.name), ball.line,
         fmt::format("robot/joint[{}]", ball.name),
         fmt::format("the ball joint is driven as hinges {0}.x, {0}.y and {0}.z", ball.name),
         fmt::format("{}.y stays within 80 degrees", ball.name)});
  }
}

std::string split_ball_joints(const std::string& urdf_text) {
  tinyxml2::XMLDocument document;
  if (document.Parse(urdf_text.c_str(), urdf_text.size()) != tinyxml2::XML_SUCCESS) {
    return urdf_text;
  }
  tinyxml2::XMLElement* robot = document.RootElement();
  std::vector<tinyxml2::XMLElement*> balls;
  for (auto* each = robot->FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    if (is_ball(*each)) balls.push_back(each);
  }
  if (balls.empty()) return urdf_text;
  for (tinyxml2::XMLElement* ball : balls) {
    append_hinges(*robot, *ball);
    robot->DeleteChild(ball);
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace treeline
