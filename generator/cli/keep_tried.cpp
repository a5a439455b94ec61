#include "cli/keep_tried.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/retry_routes.hpp"
#include "description/check_limits.hpp"

namespace treeline {
namespace {

Diagnostic describe(const FailedTrial& failed, const InputOptions& options) {
  const std::string error = failed.error <= 1e300
                                ? fmt::format("off by {:.2g} ulp of its scale", failed.error)
                                : std::string("not finite");
  return {
      Severity::error,
      "",
      0,
      failed.name,
      fmt::format("at state {} ({}) a result is {}, where {:.2g} ulp are allowed beside 50 "
                  "digits: the function is not written",
                  failed.state.index, state_class_name(failed.state.kind), error, failed.bound),
      fmt::format("This is a fault of treeline, please report it. `treeline check {} {} "
                  "--functions {} --first {} --states 1 --json` prints the state.",
                  options.urdf, options.scene, function_name(failed.function), failed.state.index)};
}

void remove(Function function, Scene& scene) {
  const bool is_damped = function == Function::damped_control_torque;
  std::erase(scene.functions, function);
  if (is_damped || std::count(kDampedFunctions.begin(), kDampedFunctions.end(), function) > 0) {
    scene.damped.reset();
  }
  const std::vector<Function> of_limits = functions_of_limits(scene);
  if (std::count(of_limits.begin(), of_limits.end(), function) > 0) scene.remove_limits();
}

}  // namespace

std::optional<GeneratedInputs> keep_tried(const InputOptions& options, GeneratedInputs made,
                                          bool& failed, Diagnostics& diagnostics) {
  const std::vector<FailedTrial> found = retry_routes(options, made, diagnostics);
  failed = !found.empty();
  if (!failed) return made;
  for (const FailedTrial& each : found) remove(each.function, made.inputs.scene);
  std::optional<GeneratedInputs> kept;
  if (!made.inputs.scene.functions.empty()) {
    kept = generate_from_inputs(options, std::move(made.inputs), made.choices, diagnostics);
  }
  for (const FailedTrial& each : found) diagnostics.add(describe(each, options));
  return kept;
}

}  // namespace treeline
