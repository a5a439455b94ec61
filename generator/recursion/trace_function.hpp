#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// The function for this mechanism as expression graphs: one for every algorithm that computes it,
/// each naming its own in `source`. At least one. The caller has seen to it that the scene permits
/// the function (operational points, objects where it needs them).
std::vector<Program> trace_function(const Mechanism& mechanism, Function function);

}  // namespace treeline
