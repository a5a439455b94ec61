#pragma once

#include <optional>
#include <vector>

#include "driving/find_start.hpp"
#include "launch/launch.hpp"

namespace treeline {

/// Where a robot stands well on a ground: its feet, those of `constraints`, as level and as far
/// apart as with all joints at 0, its legs bent by 6 % of its height where they can be, and its
/// centre of mass above the middle of what of them touches the ground. Nothing where no such place
/// is near, where the robot could not hold its weight there, or where it is not admitted.
std::optional<std::vector<double>> find_standing_start(const LaunchedRobot& robot,
                                                       const std::vector<double>& start,
                                                       const AdmitsStart& admits);

}  // namespace treeline
