#include <algorithm>

#include "comparison/difference.hpp"

namespace treeline {
namespace {

template <class Items>
std::vector<std::string> names_of(const std::vector<int>& indices, const Items& items) {
  std::vector<std::string> names;
  for (const int i : indices) names.push_back(items[static_cast<std::size_t>(i)].name);
  return names;
}

}  // namespace

bool RobotDifference::differs(const LinkDifference& link) const {
  return link.first != link.second || link.position > tolerance || link.rotation > tolerance ||
         link.mass > tolerance || link.centre > tolerance || link.inertia > tolerance;
}

bool RobotDifference::differs(const JointDifference& joint) const {
  return joint.first != joint.second || !joint.faults.empty();
}

bool RobotDifference::differs() const {
  const bool missing = !links_only_in_first.empty() || !links_only_in_second.empty() ||
                       !joints_only_in_first.empty() || !joints_only_in_second.empty();
  const bool moves_otherwise = dynamics.mass_matrix > tolerance ||
                               dynamics.gravity.relative > tolerance ||
                               dynamics.inverse_dynamics.relative > tolerance;
  return missing || moves_otherwise ||
         std::any_of(links.begin(), links.end(), [&](const auto& link) { return differs(link); }) ||
         std::any_of(joints.begin(), joints.end(),
                     [&](const auto& joint) { return differs(joint); });
}

RobotDifference compare_robots(const Robot& first, const Robot& second, Base base,
                               double tolerance) {
  const RobotMatch match = match_robots(first, second);
  RobotDifference difference;
  difference.first_file = first.file;
  difference.second_file = second.file;
  difference.first_name = first.name;
  difference.second_name = second.name;
  difference.base = base;
  difference.tolerance = tolerance;
  difference.links_only_in_first = names_of(match.links_only_in_first, first.links);
  difference.links_only_in_second = names_of(match.links_only_in_second, second.links);
  difference.joints_only_in_first = names_of(match.joints_only_in_first, first.joints);
  difference.joints_only_in_second = names_of(match.joints_only_in_second, second.joints);
  for (const Match& pair : match.links) {
    LinkDifference link;
    link.first = first.links[static_cast<std::size_t>(pair.first)].name;
    link.second = second.links[static_cast<std::size_t>(pair.second)].name;
    difference.links.push_back(link);
  }
  compare_inertias(first, second, match, difference);
  compare_joints(first, second, match, difference);
  compare_motion(first, second, match, difference);
  return difference;
}

}  // namespace treeline
