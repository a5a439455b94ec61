#include "description/join_robots.hpp"

#include <algorithm>
#include <utility>

namespace treeline {
namespace {

constexpr char kSlash = '/';

/// Adds the links, joints and loops of one robot behind a joint at the world.
void add_part(const PlacedRobot& placed, Robot& joined) {
  const std::string prefix = placed.name + kSlash;
  const auto first_link = static_cast<int>(joined.links.size());
  Joint base;
  base.name = placed.name;
  base.type = placed.base == Base::floating ? JointType::floating : JointType::fixed;
  base.parent = joined.root;
  base.child = first_link + placed.robot.root;
  base.origin = placed.pose;
  base.origin.line = 0;  // no file of a robot has it
  joined.joints.push_back(std::move(base));
  const auto first_joint = static_cast<int>(joined.joints.size());
  for (Link link : placed.robot.links) {
    link.name.insert(0, prefix);
    joined.links.push_back(std::move(link));
  }
  for (Joint joint : placed.robot.joints) {
    joint.name.insert(0, prefix);
    joint.parent += first_link;
    joint.child += first_link;
    if (joint.mimic) joint.mimic->joint += first_joint;
    joined.joints.push_back(std::move(joint));
  }
  for (RobotLoop loop : placed.robot.loops) {
    for (std::string* name : {&loop.name, &loop.first.link, &loop.second.link}) {
      name->insert(0, prefix);
    }
    joined.loops.push_back(std::move(loop));
  }
  joined.parts.push_back({placed.name, placed.robot.file});
}

}  // namespace

Robot join_robots(const std::vector<PlacedRobot>& robots, const std::string& file) {
  Robot joined;
  joined.file = file;
  joined.root = 0;
  joined.links.push_back({kWorldLink, std::nullopt, 0});
  for (const PlacedRobot& placed : robots) {
    joined.name += (joined.name.empty() ? "" : "_") + placed.name;
    add_part(placed, joined);
  }
  return joined;
}

const std::string& file_of(const Robot& robot, std::string_view name) {
  const auto part = std::find_if(
      robot.parts.begin(), robot.parts.end(),
      [owner = name.substr(0, name.find(kSlash))](const auto& each) { return each.name == owner; });
  return part == robot.parts.end() ? robot.file : part->file;
}

}  // namespace treeline
