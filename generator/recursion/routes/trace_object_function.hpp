#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Traces a function about objects, like `trace_function`: one program for every algorithm. The
/// mechanism must hold at least one object.
std::vector<Program> trace_object_function(const Mechanism& mechanism, Function function,
                                           int lanes);

}  // namespace treeline
