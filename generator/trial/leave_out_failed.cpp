#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "description/check_scene.hpp"
#include "text/round_outward.hpp"
#include "trial/retry_routes.hpp"

namespace treeline {
namespace {

/// Exact rows are divided by what nothing moves; whatever else fails is for its authors to mend.
std::string_view cause_of(const FailedTrial& failed, SingularTasks singular) {
  const bool divides_by_nothing = singular == SingularTasks::exact && !(failed.error <= 1e300);
  return divides_by_nothing ? "`singular: exact` divides by zero where no joint moves a row: with "
                              "`singular: smooth` it yields there."
                            : "This is a fault of treeline, please report it.";
}

Diagnostic describe(const FailedTrial& failed, SingularTasks singular, const std::string& files) {
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
                  failed.state.index, state_class_name(failed.state.kind), error,
                  round_up(failed.bound, 2)),
      fmt::format("{} `treeline check{} --functions {} --first {} --states 1 --json` prints the "
                  "state.",
                  cause_of(failed, singular), files, function_name(failed.function),
                  failed.state.index)};
}

void remove(Function function, Scene& scene, ChosenFunctions& chosen) {
  const bool is_damped = function == Function::damped_control_torque;
  const auto is_it = [&](const GeneratedFunction& each) { return each.function == function; };
  std::erase(scene.functions, function);
  std::erase_if(chosen.functions, is_it);
  std::erase_if(chosen.batch, is_it);
  if (is_damped || std::count(kDampedFunctions.begin(), kDampedFunctions.end(), function) > 0) {
    scene.damped.reset();
    chosen.damped.reset();
  }
  const std::vector<Function> of_limits = functions_of_limits(scene);
  if (std::count(of_limits.begin(), of_limits.end(), function) > 0) scene.remove_limits();
}

}  // namespace

void leave_out_failed(TriedFunctions& tried, const std::string& files, Diagnostics& diagnostics) {
  for (const FailedTrial& each : tried.failed) {
    remove(each.function, tried.scene, tried.chosen);
    diagnostics.add(describe(each, tried.scene.singular, files));
  }
}

}  // namespace treeline
