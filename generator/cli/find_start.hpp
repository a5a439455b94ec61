#pragma once

#include <optional>
#include <vector>

#include "drive/robot_description.hpp"
#include "drive/robot_library.hpp"

namespace treeline {

/// Whether the robot can hold its weight at rest at `q`.
bool holds_weight(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                  const std::vector<double>& q);

/// Where a robot can hold its weight with 70 % of its effort limits, found by moving one joint
/// after the other from `start`, from the base on; the best that was found where there is no such
/// place. Nothing if it can hold its weight at `start`.
std::optional<std::vector<double>> find_holdable_start(const drive::RobotLibrary& library,
                                                       const drive::RobotDescription& robot,
                                                       const std::vector<double>& start);

}  // namespace treeline
