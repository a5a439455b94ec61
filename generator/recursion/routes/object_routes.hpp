#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to a function that is about held objects, at least one.
std::vector<Route> object_routes(const RouteQuery& query);

}  // namespace treeline
