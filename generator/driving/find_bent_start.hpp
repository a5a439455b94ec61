#pragma once

#include <optional>
#include <vector>

#include "drive/robot_description.hpp"
#include "drive/robot_library.hpp"
#include "driving/find_start.hpp"

namespace treeline {

/// A place near `start` where the operational points can be moved well in every row of their task:
/// stretched arms are bent. Found by moving the joint that helps most, one after the other, where
/// the robot still holds its weight with 70 % of its effort limits, or all of them where it needs
/// more at `start`, and where `admits` does. Nothing if the task is far from singular at `start`,
/// or no better place was found.
std::optional<std::vector<double>> find_bent_start(const drive::RobotLibrary& library,
                                                   const drive::RobotDescription& robot,
                                                   const std::vector<double>& start,
                                                   const AdmitsStart& admits);

}  // namespace treeline
