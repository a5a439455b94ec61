#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bounds/bound_rounding.hpp"
#include "choice/run_routes.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "passes/choose.hpp"
#include "passes/passes.hpp"
#include "program/program.hpp"

namespace treeline {

/// One emitted function: the chosen route, the cost of the others, and the effect of the passes.
struct GeneratedFunction {
  Function function{};
  Program program;  ///< in the order of emission
  Cost chosen;
  std::vector<Cost> rejected;
  std::vector<PassReport> passes;
  int other_lanes = 0;     ///< number of lanes if it is chosen to differ from the scene's
  int batch = 0;           ///< states per call; 0: a plain function of one state
  RoundingBound rounding;  ///< within `ChosenFunctions::domain`
};

/// Converts a candidate of `run_routes` to an emitted function, except for the order of its
/// operations.
GeneratedFunction generated_from(Function function, Program candidate,
                                 const OperationCosts& costs = {});

/// Puts the operations of its straight lines in the order of emission.
void order_lines(GeneratedFunction& generated);

/// Name of the function's source file without `.cpp`; of the batch function if `batch` is not 0.
std::string source_stem(Function function, int batch);
std::string source_stem(const GeneratedFunction& generated);

/// Whether the function is `damped_control_torque`, a header without a source file that calls other
/// functions.
bool is_composed(const GeneratedFunction& generated);

/// Number of results that the function writes to its arguments: a composed one returns the last.
std::size_t count_written(const GeneratedFunction& generated);

/// Generates one function by the route that is cheapest after the passes.
GeneratedFunction generate_function(const Mechanism& mechanism, Function function,
                                    const RouteOptions& options);

/// Generates one function by the route of that key (or of those words, which earlier manifests
/// keep), like a candidate of `run_routes`. Returns nothing if there is no such route.
std::optional<GeneratedFunction> generate_chosen(const Mechanism& mechanism, Function function,
                                                 const std::string& route, RouteOptions options);

}  // namespace treeline
