#include "trial/retry_routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "choice/evaluate_damped.hpp"
#include "description/noise.hpp"
#include "mechanism/build_mechanism.hpp"
#include "text/round_outward.hpp"

namespace treeline {
namespace {

/// A function that failed first, and by which algorithm.
struct FirstFailure {
  FailedTrial failed;
  std::string route;
};

class Retry {
 public:
  Retry(const Robot& robot, TriedFunctions& tried, Diagnostics& diagnostics)
      : robot_(robot), tried_(tried), diagnostics_(diagnostics), choices_(tried.chosen.choices) {}

  void run() {
    try_chosen();
    for (auto others = choose_others(); !others.empty(); others = choose_others()) {
      if (choose_again(others)) try_chosen();
    }
    note_mended();
  }

 private:
  void try_chosen() { tried_.failed = try_functions(robot_, tried_.scene, tried_.chosen); }

  /// Null for a function of several states, or one that is composed of others.
  [[nodiscard]] GeneratedFunction* find_chosen(Function function) const {
    auto& functions = tried_.chosen.functions;
    const auto at = std::find_if(functions.begin(), functions.end(), [&](const auto& generated) {
      return generated.function == function && generated.batch == 0;
    });
    return at == functions.end() ? nullptr : &*at;
  }

  /// Names another algorithm for each that failed and has one; lists these.
  std::vector<Function> choose_others() {
    std::vector<Function> others;
    for (const FailedTrial& each : tried_.failed) {
      const GeneratedFunction* const at = find_chosen(each.function);
      const bool is_asked_for =
          choices_.plain.contains(each.function) && !first_.contains(each.function);
      if (at == nullptr || source_stem(*at) != each.name || is_asked_for) continue;
      first_.try_emplace(each.function, FirstFailure{each, describe(at->chosen.route)});
      if (choose_other(*at)) others.push_back(each.function);
    }
    return others;
  }

  bool choose_other(const GeneratedFunction& generated) {
    std::set<std::string>& had = had_[generated.function];
    had.insert(generated.chosen.route.algorithm);
    for (const Cost& other : generated.rejected) {
      if (!had.insert(other.route.algorithm).second) continue;
      choices_.plain[generated.function] = {key_of(other.route), generated.other_lanes};
      return true;
    }
    return false;
  }

  /// Chooses these again. False where an algorithm turns out not to be had; they are then as they
  /// were.
  bool choose_again(const std::vector<Function>& functions) {
    Scene scene = tried_.scene;
    scene.functions = functions;
    scene.batch = 0;
    scene.damped.reset();
    Diagnostics repeated;  // what there is to tell was told the first time
    auto again = choose_functions(robot_, scene, choices_, repeated);
    if (!again) return false;
    for (GeneratedFunction& each : again->functions) *find_chosen(each.function) = std::move(each);
    ChosenFunctions& chosen = tried_.chosen;
    chosen.choices = choices_;
    if (chosen.damped) chosen.damped = compose_damped(chosen.functions);
    return true;
  }

  /// Notes of all that failed first and do no longer.
  void note_mended() {
    for (const auto& entry : first_) {
      const FirstFailure& first = entry.second;
      const auto is_same = [&](const FailedTrial& each) { return each.name == first.failed.name; };
      if (std::any_of(tried_.failed.begin(), tried_.failed.end(), is_same)) continue;
      diagnostics_.add(
          {Severity::note, "", 0, first.failed.name,
           fmt::format("by its cheapest algorithm, {}, a result is off by {:.2g} ulp of its scale "
                       "at state {}, where {:.2g} are allowed",
                       first.route, first.failed.error, first.failed.state.index,
                       round_up(first.failed.bound, 2)),
           fmt::format("It is written by another: {}.",
                       describe(find_chosen(entry.first)->chosen.route))});
    }
  }

  const Robot& robot_;
  TriedFunctions& tried_;
  Diagnostics& diagnostics_;
  Choices choices_;  ///< those made in advance, and what takes the place of what failed
  std::map<Function, FirstFailure> first_;
  std::map<Function, std::set<std::string>> had_;  ///< algorithms
};

/// Whether numbers of files are taken as exact though the scene does not ask for it.
bool takes_numbers_as_exact(const Robot& robot, const Scene& scene) {
  return scene.noise == kResolution && !build_mechanism(robot, scene).noise.empty();
}

/// Chooses all again from numbers as the files have them, and keeps that where fewer functions
/// fail. A row that the robot can hardly move depends on digits that are noise elsewhere: with axes
/// at 1.5708 rad, a change of 1e-16 rad in a joint's frame is one of 1e-10 in such a row.
void retry_as_written(const Robot& robot, const Choices& choices, TriedFunctions& tried,
                      Diagnostics& diagnostics) {
  TriedFunctions again{tried.scene, {}};
  again.scene.noise = 0;
  Diagnostics told, found;
  auto chosen = choose_functions(robot, again.scene, choices, told);
  if (!chosen) return;
  again.chosen = std::move(*chosen);
  Retry(robot, again, found).run();
  if (again.failed.size() >= tried.failed.size()) return;
  const FailedTrial& first = tried.failed.front();
  diagnostics.add({Severity::note, "", 0, first.name,
                   fmt::format("where numbers of the files are taken as exact, a result is off by "
                               "{:.2g} ulp of its scale at state {}, where {:.2g} are allowed",
                               first.error, first.state.index, round_up(first.bound, 2)),
                   "So all numbers are used as they are written, as `noise: keep` would ask for."});
  for (const Diagnostic& each : found.list()) diagnostics.add(each);
  tried = std::move(again);
}

}  // namespace

TriedFunctions retry_routes(const Robot& robot, const Scene& scene, ChosenFunctions chosen,
                            Diagnostics& diagnostics) {
  TriedFunctions tried{scene, std::move(chosen)};
  const Choices made_in_advance = tried.chosen.choices;
  Diagnostics found;
  Retry(robot, tried, found).run();
  const std::size_t before = tried.failed.size();
  if (before > 0 && takes_numbers_as_exact(robot, scene)) {
    retry_as_written(robot, made_in_advance, tried, diagnostics);
  }
  if (tried.failed.size() < before) return tried;
  for (const Diagnostic& each : found.list()) diagnostics.add(each);
  return tried;
}

}  // namespace treeline
