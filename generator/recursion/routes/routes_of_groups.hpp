#pragma once

#include <string>
#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to a function that is about the robot or its operational points, at least one; none
/// for other functions.
std::vector<Route> robot_routes(const RouteQuery& query);

/// The routes to a function that is about the centre of mass, at least one.
std::vector<Route> posture_routes(const RouteQuery& query);

/// The routes to derivatives of inverse or forward dynamics, at least one. Results are nv x nv,
/// row-major: entry (i, j) is the change of result i per unit of velocity, acceleration, force or
/// displacement j. A displacement is a tangent: for a floating joint a twist of the child in its
/// own axes (linear over angular), for every other joint a change of its coordinate.
std::vector<Route> derivative_routes(const RouteQuery& query);

/// The routes to a function that is about contacts or links, at least one.
std::vector<Route> contact_routes(const RouteQuery& query);

/// Key of the routes that eliminate what constraints determine.
inline constexpr const char* kEliminatedKey = "eliminated";

/// Why there is no such route to the function, and what to do; empty if there is.
std::string why_not_eliminated(const Mechanism& mechanism, Function function);

/// The routes to a function that is about constraints, at least one.
std::vector<Route> constraint_routes(const RouteQuery& query);

/// The routes to a function that is about held objects, at least one.
std::vector<Route> object_routes(const RouteQuery& query);

}  // namespace treeline
