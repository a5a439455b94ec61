#pragma once

#include <vector>

#include "description/robot.hpp"

namespace treeline {

/// A link or a joint that both robots have, by its index in each.
struct Match {
  int first = -1, second = -1;
};

/// Which links and joints of two robots are the same.
struct RobotMatch {
  std::vector<Match> links, joints;  ///< in the order of the first robot
  std::vector<int> links_only_in_first, links_only_in_second;
  std::vector<int> joints_only_in_first, joints_only_in_second;
};

/// Links and joints of one name are the same. What is left over is matched by its place in the
/// tree, as renamed: the roots, the child of a joint that is in both, a joint that connects two
/// links that are in both, and of the joints that leave such a link those of one type that start
/// nearest to each other.
RobotMatch match_robots(const Robot& first, const Robot& second);

}  // namespace treeline
