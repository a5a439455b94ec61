#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to a function that is about constraints, at least one.
std::vector<Route> constraint_routes(const RouteQuery& query);

}  // namespace treeline
