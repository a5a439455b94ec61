#pragma once

#include <string>

#include "recursion/lambda_routes.hpp"

namespace treeline {

/// Name of a link's axes: `the axes of link 3 (forearm)`. Links count from 1.
std::string axes_name(int link, const Tree<Expression>& tree);
/// Name of a route to Lambda^-1 in reports.
const char* name_of(LambdaRoute route);
/// Name of a route to Lambda^-1 together with its coordinates.
std::string describe(const LambdaChoice& choice, const Tree<Expression>& tree);

}  // namespace treeline
