#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// As `trace_function` for one of `kDerivativeFunctions`. Results are nv x nv, row-major: entry
/// (i, j) is what a unit of velocity, acceleration, force or displacement j does to result i. A
/// displacement is a tangent: of a floating joint, a twist of the child (linear over angular) in
/// its own axes; of every other joint, a change of its coordinate.
std::vector<Program> trace_derivative_function(const Mechanism& mechanism, Function function,
                                               int lanes = 1);

}  // namespace treeline
