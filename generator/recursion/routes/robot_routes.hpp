#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to a function that is about the robot or its operational points, at least one; none
/// for other functions.
std::vector<Route> robot_routes(const RouteQuery& query);

}  // namespace treeline
