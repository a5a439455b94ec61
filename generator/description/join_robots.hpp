#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Name of the link at which robots are joined.
inline constexpr const char* kWorldLink = "world";

/// A robot and where it stands.
struct PlacedRobot {
  std::string name;  ///< an identifier, other than the names of all others and `world`
  Robot robot;
  Base base = Base::fixed;
  Pose pose;  ///< of a fixed base: root link in the world
};

/// One tree of several robots: a link `world` without mass, and joined to it the root of each, by a
/// fixed joint at its pose or by a floating joint. The joint has the robot's name; names of its
/// links, joints and loops begin with it and a slash. Coordinates are those of each alone, one
/// robot after another; those of a floating base are its pose in the world. Masses, limits, mimics
/// and what else the files say stay as they are. `file` is where the list of robots stands.
Robot join_robots(const std::vector<PlacedRobot>& robots, const std::string& file);

/// Path of the file in which the link or joint `name` stands, for diagnostics.
const std::string& file_of(const Robot& robot, std::string_view name);

}  // namespace treeline
