#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Traces one of `kDerivativeFunctions`, like `trace_function`: one program for every algorithm.
/// Results are nv x nv, row-major: entry (i, j) is the change of result i per unit of velocity,
/// acceleration, force or displacement j. A displacement is a tangent: for a floating joint a twist
/// of the child in its own axes (linear over angular), for every other joint a change of its
/// coordinate.
std::vector<Program> trace_derivative_function(const Mechanism& mechanism, Function function,
                                               int lanes = 1);

}  // namespace treeline
