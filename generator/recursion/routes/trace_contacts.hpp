#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Traces one of `kContactFunctions`, like `trace_function`: one program for every algorithm.
std::vector<Program> trace_contact_function(const Mechanism& mechanism, Function function,
                                            int lanes);

}  // namespace treeline
