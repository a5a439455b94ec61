#pragma once

#include <vector>

#include "description/robot.hpp"

namespace treeline {

/// A link or joint that both robots have, by its index in each.
struct Match {
  int first = -1, second = -1;
};

/// The correspondence of links and joints of two robots.
struct RobotMatch {
  std::vector<Match> links, joints;  ///< in the order of the first robot
  std::vector<int> links_only_in_first, links_only_in_second;
  std::vector<int> joints_only_in_first, joints_only_in_second;
};

/// Matches links and joints of the same name. The others are matched as renamed by their places in
/// the tree: the roots; the children of a joint that is in both; a joint that connects two links
/// that are in both; and, of the joints that leave such a link, those of the same type whose
/// origins are nearest to each other.
RobotMatch match_robots(const Robot& first, const Robot& second);

}  // namespace treeline
