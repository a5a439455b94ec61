#pragma once

#include <string>
#include <vector>

#include "interpreter/golden.hpp"
#include "random_mechanism.hpp"

namespace treeline::tests {

struct RobotInScene {
  std::string name;  ///< of the robot's folder and the scene's file
  Robot robot;
  Scene scene;
};

/// Reads every robot of the project in each of its scenes, in the order of their names. Throws if a
/// file is bad.
std::vector<RobotInScene> read_robots();

}  // namespace treeline::tests
