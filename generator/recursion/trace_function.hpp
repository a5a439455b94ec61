#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// The function for this mechanism as expression graphs: one for every algorithm that computes it,
/// each naming its own in `source`. At least one. The caller has seen to it that the scene permits
/// the function (operational points, objects where it needs them).
/// `lanes`: how many values of Real the emitted code may compute together.
std::vector<Program> trace_function(const Mechanism& mechanism, Function function, int lanes = 1);

/// The same by the algorithm of this `source` alone, to be counted: names may be missing.
Program trace_route(const Mechanism& mechanism, Function function, const std::string& source);

}  // namespace treeline
