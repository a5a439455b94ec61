#pragma once

#include <functional>
#include <string>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Traces a function of this mechanism as expression graphs: one program for every algorithm that
/// computes it, in each of its coordinates; `source` names both. For long functions, algorithms
/// that are pruned in the first coordinates are traced only there. There is at least one program.
/// The scene must permit the function (operational points or objects if it needs them). `lanes` is
/// the number of Real values that the emitted code may compute together.
std::vector<Program> trace_function(const Mechanism& mechanism, Function function, int lanes = 1);

/// Whether a trace keeps the names of its values, and its sections.
enum class Names { kept, forgotten };

/// Returns a function that traces `function` by the algorithm with this `source` alone, for
/// counting operations. Each call uses the mechanism as it is then; only choices within links may
/// have changed. Names and sections are kept if `names` says so.
std::function<Program(Names names)> prepare_route(const Mechanism& mechanism, Function function,
                                                  const std::string& source);

}  // namespace treeline
