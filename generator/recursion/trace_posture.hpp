#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// As `trace_function` for one of `kPostureFunctions`.
std::vector<Program> trace_posture_function(const Mechanism& mechanism, Function function,
                                            int lanes);

}  // namespace treeline
