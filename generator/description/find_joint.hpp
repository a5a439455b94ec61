#pragma once

#include <string>

#include "description/robot.hpp"

namespace treeline {

/// The joint of that name; null if there is none, as for a floating base.
const Joint* find_joint(const Robot& robot, const std::string& name);

}  // namespace treeline
