#pragma once

#include <string>
#include <vector>

#include "recursion/routes/trace.hpp"

namespace treeline {

/// Key of the routes that eliminate what constraints determine.
inline constexpr const char* kEliminatedKey = "eliminated";

/// Why there is no such route to the function, and what to do; empty if there is.
std::string why_not_eliminated(const Mechanism& mechanism, Function function);

/// The routes to a function that is about constraints, at least one.
std::vector<Route> constraint_routes(const RouteQuery& query);

}  // namespace treeline
