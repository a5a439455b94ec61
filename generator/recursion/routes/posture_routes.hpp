#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to a function that is about the centre of mass, at least one.
std::vector<Route> posture_routes(const RouteQuery& query);

}  // namespace treeline
