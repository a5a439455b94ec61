#pragma once

#include <vector>

#include "recursion/routes/robot_routes.hpp"

// Routes to derivatives of energy and of the motion of points, see `robot_routes`.

namespace treeline {

std::vector<RobotRoute> kinetic_energy_derivative_routes();
std::vector<RobotRoute> point_velocity_derivative_routes();
std::vector<RobotRoute> point_acceleration_derivative_routes();

}  // namespace treeline
