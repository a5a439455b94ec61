#pragma once

#include "description/robot.hpp"

namespace treeline {

/// Mass of all links, kg.
double total_mass(const Robot& robot);

}  // namespace treeline
