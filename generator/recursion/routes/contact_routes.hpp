#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to a function that is about contacts or links, at least one.
std::vector<Route> contact_routes(const RouteQuery& query);

}  // namespace treeline
