#include "cli/retry_routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "description/noise.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

/// A function that failed first, and by which algorithm.
struct FirstFailure {
  FailedTrial failed;
  std::string route;
};

class Retry {
 public:
  Retry(const InputOptions& options, GeneratedInputs& made, Diagnostics& diagnostics)
      : options_(options), made_(made), diagnostics_(diagnostics), choices_(made.choices) {}

  std::vector<FailedTrial> run() {
    std::vector<FailedTrial> failed = try_made();
    while (!failed.empty() && choose_others(failed)) {
      if (make_again()) failed = try_made();
    }
    note_mended(failed);
    return failed;
  }

 private:
  [[nodiscard]] std::vector<FailedTrial> try_made() const {
    return try_functions(made_.inputs.robot, made_.inputs.scene, made_.generation);
  }

  /// Null for a function of several states, or one that is composed of others.
  [[nodiscard]] const GeneratedFunction* find_made(Function function) const {
    const auto& functions = made_.generation.functions;
    const auto at = std::find_if(functions.begin(), functions.end(), [&](const auto& generated) {
      return generated.function == function && generated.batch == 0;
    });
    return at == functions.end() ? nullptr : &*at;
  }

  /// Whether there is another algorithm for one of them.
  bool choose_others(const std::vector<FailedTrial>& failed) {
    bool chosen = false;
    for (const FailedTrial& each : failed) {
      const GeneratedFunction* const at = find_made(each.function);
      const bool is_asked_for =
          choices_.plain.contains(each.function) && !first_.contains(each.function);
      if (at == nullptr || source_stem(*at) != each.name || is_asked_for) continue;
      first_.try_emplace(each.function, FirstFailure{each, describe(at->chosen.route)});
      chosen = choose_other(*at) || chosen;
    }
    return chosen;
  }

  bool choose_other(const GeneratedFunction& generated) {
    std::set<std::string>& tried = tried_[generated.function];
    tried.insert(generated.chosen.route.algorithm);
    for (const Cost& other : generated.rejected) {
      if (!tried.insert(other.route.algorithm).second) continue;
      choices_.plain[generated.function] = {key_of(other.route), generated.other_lanes};
      return true;
    }
    return false;
  }

  /// False where an algorithm turns out not to be had; the code is then as it was.
  bool make_again() {
    Diagnostics repeated;  // what there is to tell was told the first time
    auto again = generate_from_inputs(options_, made_.inputs, choices_, repeated);
    if (again) made_ = std::move(*again);
    return again.has_value();
  }

  /// Notes of all that failed first and do no longer.
  void note_mended(const std::vector<FailedTrial>& failed) {
    for (const auto& entry : first_) {
      const FirstFailure& first = entry.second;
      const auto is_same = [&](const FailedTrial& each) { return each.name == first.failed.name; };
      if (std::any_of(failed.begin(), failed.end(), is_same)) continue;
      diagnostics_.add(
          {Severity::note, "", 0, first.failed.name,
           fmt::format("by its cheapest algorithm, {}, a result is off by {:.2g} ulp of its scale "
                       "at state {}, where {:.2g} are allowed",
                       first.route, first.failed.error, first.failed.state.index,
                       first.failed.bound),
           fmt::format("It is written by another: {}.",
                       describe(find_made(entry.first)->chosen.route))});
    }
  }

  const InputOptions& options_;
  GeneratedInputs& made_;
  Diagnostics& diagnostics_;
  Choices choices_;  ///< those asked for, and what takes the place of what failed
  std::map<Function, FirstFailure> first_;
  std::map<Function, std::set<std::string>> tried_;  ///< algorithms
};

/// Whether numbers of files are taken as exact though the scene does not ask for it.
bool takes_numbers_as_exact(const RobotAndScene& inputs) {
  return inputs.scene.noise == kResolution &&
         !build_mechanism(inputs.robot, inputs.scene).noise.empty();
}

/// Makes all again from numbers as the files have them, and keeps that where fewer functions fail.
/// A row that the robot can hardly move depends on digits that are noise elsewhere: with axes at
/// 1.5708 rad, a change of 1e-16 rad in a joint's frame is one of 1e-10 in such a row.
std::vector<FailedTrial> retry_as_written(const InputOptions& options, const Choices& choices,
                                          std::vector<FailedTrial> failed, GeneratedInputs& made,
                                          Diagnostics& diagnostics) {
  RobotAndScene inputs = made.inputs;
  inputs.scene.noise = 0;
  Diagnostics told, found;
  auto again = generate_from_inputs(options, std::move(inputs), choices, told);
  if (!again) return failed;
  std::vector<FailedTrial> left = Retry(options, *again, found).run();
  if (left.size() >= failed.size()) return failed;
  made = std::move(*again);
  const FailedTrial& first = failed.front();
  diagnostics.add({Severity::note, "", 0, first.name,
                   fmt::format("where numbers of the files are taken as exact, a result is off by "
                               "{:.2g} ulp of its scale at state {}, where {:.2g} are allowed",
                               first.error, first.state.index, first.bound),
                   "So all numbers are used as they are written, as `noise: keep` would ask for."});
  for (const Diagnostic& each : found.list()) diagnostics.add(each);
  return left;
}

}  // namespace

std::vector<FailedTrial> retry_routes(const InputOptions& options, GeneratedInputs& made,
                                      Diagnostics& diagnostics) {
  const Choices asked_for = made.choices;
  Diagnostics found;
  std::vector<FailedTrial> failed = Retry(options, made, found).run();
  const std::size_t before = failed.size();
  if (!failed.empty() && takes_numbers_as_exact(made.inputs)) {
    failed = retry_as_written(options, asked_for, std::move(failed), made, diagnostics);
  }
  if (failed.size() < before) return failed;
  for (const Diagnostic& each : found.list()) diagnostics.add(each);
  return failed;
}

}  // namespace treeline
