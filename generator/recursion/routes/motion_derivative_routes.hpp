#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

// Routes to derivatives of energy and of the motion of points, see `robot_routes`.

namespace treeline {

std::vector<Route> kinetic_energy_derivative_routes();
std::vector<Route> point_velocity_derivative_routes();
std::vector<Route> point_acceleration_derivative_routes();

}  // namespace treeline
