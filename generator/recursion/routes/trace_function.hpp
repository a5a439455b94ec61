#pragma once

#include <functional>
#include <string>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// The function for this mechanism as expression graphs: one for every algorithm that computes it,
/// in each of its coordinates, each naming its own in `route`; of long ones that are pruned in
/// the first coordinates these alone. At least one. The caller has seen to it that the scene
/// permits the function (operational points, objects where it needs them). `lanes`: how many values
/// of Real the emitted code may compute together.
std::vector<Program> trace_function(const Mechanism& mechanism, Function function, int lanes = 1);

/// Whether a trace keeps the names of its values, and its sections.
enum class Names { kept, forgotten };

/// Traces the function by this route alone, to be counted, each time that it is
/// called: as the mechanism is then, of which only choices within links may have changed. Names,
/// and sections with them, are kept where `names` says so.
std::function<Program(Names names)> prepare_route(const Mechanism& mechanism, Function function,
                                                  const RouteId& id);

}  // namespace treeline
