#include <fmt/format.h>

#include <map>
#include <string_view>

#include "description/urdf_parts.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr int kNone = -1;

class LinkNames {
 public:
  explicit LinkNames(const Robot& robot) {
    for (const Link& link : robot.links) {
      indices_.try_emplace(link.name, static_cast<int>(names_.size()));
      names_.push_back(link.name);
    }
  }

  /// Index of a link; an error at the joint when there is none.
  int find(const std::string& name, const char* end, const UrdfElement& joint) const {
    if (name.empty()) return kNone;  // reported when it was read
    const auto found = indices_.find(name);
    if (found != indices_.end()) return found->second;
    const std::string suggestion = suggest_name(name, names_, "the links are");
    joint.error(fmt::format("the {} link \"{}\" is not defined", end, name),
                suggestion.empty() ? "add the link" : suggestion);
    return kNone;
  }

 private:
  std::map<std::string, int> indices_;
  std::vector<std::string> names_;
};

/// Finds for each link the joint of which it is the child.
std::vector<int> find_parent_joints(const std::vector<NamedJoint>& joints, std::size_t links) {
  std::vector<int> parent_joint(links, kNone);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j].joint;
    if (joint.child == kNone) continue;
    int& holder = parent_joint[static_cast<std::size_t>(joint.child)];
    if (holder == kNone) {
      holder = static_cast<int>(j);
      continue;
    }
    const NamedJoint& first = joints[static_cast<std::size_t>(holder)];
    joints[j].element.error(
        fmt::format(
            "the link \"{}\" has two parents: it is already the child of joint \"{}\" in line {}",
            joints[j].child, first.joint.name, first.joint.line),
        "remove one of the joints, and close the loop by constraints in the scene");
  }
  return parent_joint;
}

int find_root(const std::vector<int>& parent_joint, const std::vector<UrdfElement>& elements,
              Robot& robot) {
  int root = kNone;
  for (std::size_t i = 0; i < parent_joint.size(); ++i) {
    if (parent_joint[i] != kNone) continue;
    if (root == kNone) {
      root = static_cast<int>(i);
      continue;
    }
    const Link& first = robot.links[static_cast<std::size_t>(root)];
    elements[i].error(
        fmt::format(
            "a second root: neither this link nor \"{}\" in line {} is the child of a joint",
            first.name, first.line),
        "connect the two by a joint, or remove one");
  }
  return root;
}

std::string describe_loop(std::size_t link, const std::vector<int>& parent_joint,
                          const Robot& robot) {
  const auto above = [&](std::size_t i) {
    const auto joint = static_cast<std::size_t>(parent_joint[i]);
    return static_cast<std::size_t>(robot.joints[joint].parent);
  };
  for (std::size_t step = 0; step < parent_joint.size(); ++step) link = above(link);
  std::string names = robot.links[link].name;
  for (std::size_t i = above(link); i != link; i = above(i)) names += " - " + robot.links[i].name;
  return names + " - " + robot.links[link].name;
}

/// Links that lead to no root lead into a loop.
void find_loop(const std::vector<int>& parent_joint, const std::vector<UrdfElement>& elements,
               const Robot& robot) {
  enum class State { unknown, on_path, rooted };
  std::vector<State> state(parent_joint.size(), State::unknown);
  for (std::size_t start = 0; start < parent_joint.size(); ++start) {
    std::vector<std::size_t> path;
    std::size_t link = start;
    while (state[link] == State::unknown && parent_joint[link] != kNone) {
      state[link] = State::on_path;
      path.push_back(link);
      const auto joint = static_cast<std::size_t>(parent_joint[link]);
      link = static_cast<std::size_t>(robot.joints[joint].parent);
    }
    if (state[link] == State::on_path) {
      elements[link].error(
          fmt::format("the links form a loop: {}", describe_loop(link, parent_joint, robot)),
          "remove one of its joints: the links must form a tree with one root");
      return;
    }
    state[link] = State::rooted;
    for (const std::size_t i : path) state[i] = State::rooted;
  }
}

}  // namespace

void connect_tree(std::vector<NamedJoint>& joints, const std::vector<UrdfElement>& elements,
                  Robot& robot, UrdfReading& reading) {
  const LinkNames names(robot);
  for (NamedJoint& named : joints) {
    named.joint.parent = names.find(named.parent, "parent", named.element);
    named.joint.child = names.find(named.child, "child", named.element);
    if (named.joint.parent == named.joint.child && named.joint.parent != kNone) {
      named.element.error(fmt::format("the link \"{}\" is its own parent", named.parent),
                          "name two different links");
    }
    robot.joints.push_back(named.joint);
  }
  const std::vector<int> parent_joint = find_parent_joints(joints, robot.links.size());
  if (reading.failed()) return;
  robot.root = find_root(parent_joint, elements, robot);
  find_loop(parent_joint, elements, robot);
}

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
