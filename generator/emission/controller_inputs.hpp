#pragma once

#include <string>
#include <vector>

#include "emission/controller_unit.hpp"

namespace treeline {

/// Returns the step's own variable for an argument of the functions that it calls: `at->q` for q.
/// Empty for an argument that the caller of the step brings.
std::string variable_of(const std::string& argument);

/// Whether an argument describes the robot: the step leads it to what it becomes, so that torques
/// have no step. Places of tools and known forces are taken as they are.
bool is_led(const std::string& argument);

/// Lists the arguments that the caller of the step brings beside q and qd: what of the robot
/// changes, and known forces.
std::vector<Argument> list_inputs(const ControllerUnit& unit);

}  // namespace treeline
