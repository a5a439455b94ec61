#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "description/robot.hpp"

namespace treeline {

/// The joint of that name; null if there is none, as for a floating base.
const Joint* find_joint(const Robot& robot, const std::string& name);

/// Where a link of that name is among those of the robot; their number where there is none.
inline std::size_t index_of_link(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const Link& link) { return link.name == name; });
  return static_cast<std::size_t>(found - robot.links.begin());
}

/// Mass of all links, kg.
double total_mass(const Robot& robot);

/// The robot's joints in the order in which coordinates are numbered: depth first from the root,
/// the children of a link in the file's order. Every joint comes after the one that carries its
/// parent link. Indices into `Robot::joints`. The robot must be a tree, of any depth.
std::vector<int> joints_depth_first(const Robot& robot);

/// Every link on a line of its own below the link that carries it, indented; of a large robot, the
/// first and how many more there are.
std::string list_links(const Robot& robot);

/// The joints that move, see `list_names`.
std::string list_moving_joints(const Robot& robot);

/// Suggests what to do about the name of a link that the robot does not have: `did you mean
/// "..."?`, or the links by tree.
std::string suggest_link(const std::string& name, const Robot& robot);

/// Suggests what to do about the name of a joint that the robot does not have.
std::string suggest_joint(const std::string& name, const Robot& robot);

}  // namespace treeline
