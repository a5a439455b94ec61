#include "cli/retry_routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace treeline {
namespace {

class Retry {
 public:
  Retry(const InputOptions& options, GeneratedInputs& made, Diagnostics& diagnostics)
      : options_(options), made_(made), diagnostics_(diagnostics), asked_(made.choices) {}

  std::vector<FailedTrial> run() {
    std::vector<FailedTrial> failed = try_made();
    while (!failed.empty() && choose_others(failed) && make_again()) failed = try_made();
    return failed;
  }

 private:
  [[nodiscard]] std::vector<FailedTrial> try_made() const {
    return try_functions(made_.inputs.robot, made_.inputs.scene, made_.generation);
  }

  /// Whether there is another algorithm for one of them.
  bool choose_others(const std::vector<FailedTrial>& failed) {
    bool chosen = false;
    for (const FailedTrial& each : failed) {
      const auto& functions = made_.generation.functions;
      const auto at = std::find_if(functions.begin(), functions.end(), [&](const auto& generated) {
        return generated.function == each.function && source_stem(generated) == each.name;
      });
      if (at == functions.end() || at->batch > 0 || asked_.plain.contains(each.function)) continue;
      chosen = choose_other(*at, each) || chosen;
    }
    return chosen;
  }

  bool choose_other(const GeneratedFunction& generated, const FailedTrial& failed) {
    std::set<std::string>& tried = tried_[generated.function];
    tried.insert(generated.chosen.route.algorithm);
    const auto other =
        std::find_if(generated.rejected.begin(), generated.rejected.end(),
                     [&](const Cost& cost) { return !tried.contains(cost.route.algorithm); });
    if (other == generated.rejected.end()) return false;
    diagnostics_.add({Severity::note, "", 0, failed.name,
                      fmt::format("by its cheapest algorithm, {}, a result is off by {:.2g} ulp "
                                  "of its scale at state {}, where {:.2g} are allowed",
                                  describe(generated.chosen.route), failed.error,
                                  failed.state.index, failed.bound),
                      fmt::format("It is written by another: {}.", describe(other->route))});
    made_.choices.plain[generated.function] = {key_of(other->route), generated.other_lanes};
    return true;
  }

  /// False where an algorithm turns out not to be had; the code is then as it was.
  bool make_again() {
    Diagnostics repeated;  // what there is to tell was told the first time
    auto again = generate_from_inputs(options_, made_.inputs, made_.choices, repeated);
    if (!again) return false;
    made_ = std::move(*again);
    return true;
  }

  const InputOptions& options_;
  GeneratedInputs& made_;
  Diagnostics& diagnostics_;
  const Choices asked_;
  std::map<Function, std::set<std::string>> tried_;
};

}  // namespace

std::vector<FailedTrial> retry_routes(const InputOptions& options, GeneratedInputs& made,
                                      Diagnostics& diagnostics) {
  return Retry(options, made, diagnostics).run();
}

}  // namespace treeline
