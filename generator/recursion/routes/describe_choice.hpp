#pragma once

#include <string>

#include "program/route_id.hpp"
#include "recursion/methods/lambda_routes.hpp"

namespace treeline {

/// Name of a link's axes: `the axes of link 3 (forearm)`. Links count from 1.
std::string axes_name(int link, const Tree<Expression>& tree);
/// `link-3`.
std::string axes_key(int link);

/// A route to Lambda^-1, without coordinates.
RouteId route_id(LambdaRoute route);
/// A route to Lambda^-1, with the coordinates in which it is computed.
RouteId route_id(const LambdaChoice& choice, const Tree<Expression>& tree);

/// The route of a function that is computed out of Lambda^-1: `key` and `words` are its own.
RouteId on_top_of(const RouteId& lambda_inverse, const std::string& key, const std::string& words);

}  // namespace treeline
