#pragma once

#include <string>

#include "description/robot.hpp"

namespace treeline {

/// Every link on a line of its own below the link that carries it, indented; of a large robot, the
/// first and how many more there are.
std::string list_links(const Robot& robot);

/// The joints that move, see `list_names`.
std::string list_moving_joints(const Robot& robot);

/// Suggests what to do about the name of a link that the robot does not have: `did you mean
/// "..."?`, or the links by tree.
std::string suggest_link(const std::string& name, const Robot& robot);

/// Suggests what to do about the name of a joint that the robot does not have.
std::string suggest_joint(const std::string& name, const Robot& robot);

}  // namespace treeline
