#include "description/robot_queries.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/suggest_name.hpp"

namespace treeline {

const Joint* find_joint(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  return found == robot.joints.end() ? nullptr : &*found;
}

double total_mass(const Robot& robot) {
  double mass = 0;
  for (const Link& link : robot.links) mass += link.inertial ? link.inertial->mass : 0;
  return mass;
}

std::vector<int> joints_depth_first(const Robot& robot) {
  std::vector<std::vector<int>> leaving(robot.links.size());  // joints of each link, the last first
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    leaving[static_cast<std::size_t>(robot.joints[j].parent)].push_back(static_cast<int>(j));
  }
  std::vector<int> order;
  std::vector<int> next = leaving[static_cast<std::size_t>(robot.root)];
  while (!next.empty()) {
    const int joint = next.back();
    next.pop_back();
    order.push_back(joint);
    const auto child =
        static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(joint)].child);
    next.insert(next.end(), leaving[child].begin(), leaving[child].end());
  }
  return order;
}

namespace {

constexpr std::size_t kMostLines = 40;
constexpr std::size_t kDeepest = 20;  ///< levels that are indented

struct Visit {
  std::size_t link;
  std::size_t depth;
};

/// Links with their depths, depth first, children in the file's order.
std::vector<Visit> walk_links(const Robot& robot) {
  std::vector<std::size_t> depths(robot.links.size(), 0);
  std::vector<Visit> visits{{static_cast<std::size_t>(robot.root), 0}};
  for (const int j : joints_depth_first(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    const auto child = static_cast<std::size_t>(joint.child);
    depths[child] = depths[static_cast<std::size_t>(joint.parent)] + 1;
    visits.push_back({child, depths[child]});
  }
  return visits;
}

}  // namespace

std::string list_links(const Robot& robot) {
  const std::vector<Visit> visits = walk_links(robot);
  const std::size_t listed = std::min(visits.size(), kMostLines);
  std::string text;
  for (std::size_t i = 0; i < listed; ++i) {
    const std::string indent(2 * (1 + std::min(visits[i].depth, kDeepest)), ' ');
    text += (i == 0 ? "" : "\n") + indent + robot.links[visits[i].link].name;
  }
  if (listed == visits.size()) return text;
  return text +
         fmt::format("\n  and {} more, which `treeline inspect` lists", visits.size() - listed);
}

std::string list_moving_joints(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) {
    if (info_of(joint.type).moves()) names.push_back(joint.name);
  }
  return list_names(names);
}

std::string suggest_link(const std::string& name, const Robot& robot) {
  std::vector<std::string> names;
  for (const Link& link : robot.links) names.push_back(link.name);
  const std::string near = find_near_name(name, names);
  if (!near.empty()) return near;
  const bool is_joint = std::any_of(robot.joints.begin(), robot.joints.end(),
                                    [&](const Joint& joint) { return joint.name == name; });
  return fmt::format("{}its links are, each below the one that carries it:\n{}",
                     is_joint ? "this is a joint; " : "", list_links(robot));
}

std::string suggest_joint(const std::string& name, const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) names.push_back(joint.name);
  const std::string near = find_near_name(name, names);
  return near.empty() ? "its joints that move are " + list_moving_joints(robot) : near;
}

}  // namespace treeline
