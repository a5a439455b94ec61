#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to derivatives of inverse or forward dynamics, at least one. Results are nv x nv,
/// row-major: entry (i, j) is the change of result i per unit of velocity, acceleration, force or
/// displacement j. A displacement is a tangent: for a floating joint a twist of the child in its
/// own axes (linear over angular), for every other joint a change of its coordinate.
std::vector<Route> derivative_routes(const RouteQuery& query);

}  // namespace treeline
