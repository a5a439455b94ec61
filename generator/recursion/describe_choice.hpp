#pragma once

#include <string>

#include "recursion/lambda_routes.hpp"

namespace treeline {

/// What a way to Lambda^-1 is called in reports.
std::string describe(const LambdaChoice& choice, const Tree<Expression>& tree);

}  // namespace treeline
