#pragma once

#include <vector>

#include "functions/function.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Traces every route to a function about constraints or passive joints.
std::vector<Program> trace_constraint_function(const Mechanism& mechanism, Function function,
                                               int lanes);

}  // namespace treeline
