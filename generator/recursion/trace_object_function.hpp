#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// As `trace_function`, for the functions about objects; the mechanism holds at least one.
std::vector<Program> trace_object_function(const Mechanism& mechanism, Function function,
                                           int lanes);

}  // namespace treeline
