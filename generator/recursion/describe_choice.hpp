#pragma once

#include <string>

#include "recursion/lambda_routes.hpp"

namespace treeline {

/// `the axes of link 3 (forearm)`; links count from 1.
std::string axes_name(int link, const Tree<Expression>& tree);
/// What a route to Lambda^-1 is called in reports.
const char* name_of(LambdaRoute route);
/// The same with the coordinates that it is worked out in.
std::string describe(const LambdaChoice& choice, const Tree<Expression>& tree);

}  // namespace treeline
