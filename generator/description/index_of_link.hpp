#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "description/robot.hpp"

namespace treeline {

/// Where a link of that name is among those of the robot; their number where there is none.
inline std::size_t index_of_link(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const Link& link) { return link.name == name; });
  return static_cast<std::size_t>(found - robot.links.begin());
}

}  // namespace treeline
