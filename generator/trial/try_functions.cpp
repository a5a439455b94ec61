#include "trial/try_functions.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "choice/for_each_index.hpp"
#include "oracle/bound.hpp"
#include "oracle/reference.hpp"
#include "oracle/reference_maker.hpp"

namespace treeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Finds the state at which function `i` exceeds its bound the most. Nothing if it stays within the
/// bound.
std::optional<FailedTrial> judge(std::size_t i, const GeneratedFunction& generated,
                                 const std::vector<StateReference>& references, double unit) {
  const Bound bound = find_bound(i, generated.function, references);
  std::optional<FailedTrial> worst;
  double largest = 1;  // largest ratio of error to bound
  for (const StateReference& reference : references) {
    const FunctionReference& at = reference.functions[i];
    if (at.graph.empty()) continue;
    const bool lost = at.singular && at.stays_finite && !are_finite(at.graph);
    if (at.singular && !lost) continue;
    const double error = lost ? kInfinity : error_in_ulp(at.graph, at, unit);
    const double allowed = lost ? Bound::kFloorUlp : bound.at(at);
    const double share = error / allowed;
    if (share <= largest) continue;
    largest = share;
    worst = {generated.function, source_stem(generated), reference.state, error, allowed};
  }
  return worst;
}

std::vector<Function> functions_of(const std::vector<GeneratedFunction>& generated) {
  std::vector<Function> functions;
  for (const GeneratedFunction& each : generated) functions.push_back(each.function);
  return functions;
}

/// Keeps of the chosen functions these and those that they are composed of.
ChosenFunctions keep(const ChosenFunctions& chosen, const std::vector<Function>& wanted) {
  const auto is_unwanted = [&](const GeneratedFunction& generated) {
    return std::none_of(wanted.begin(), wanted.end(), [&](Function function) {
      return function == generated.function ||
             (function == Function::damped_control_torque &&
              std::count(kDampedFunctions.begin(), kDampedFunctions.end(), generated.function) > 0);
    });
  };
  ChosenFunctions kept = chosen;
  std::erase_if(kept.functions, is_unwanted);
  std::erase_if(kept.batch, is_unwanted);
  if (kept.damped && is_unwanted(*kept.damped)) kept.damped.reset();
  return kept;
}

/// Judges functions at few states, computing 50 digits only where necessary.
class Trial {
 public:
  Trial(const ReferenceMaker& maker, const std::vector<int>& states, double unit)
      : maker_(maker), unit_(unit), references_(states.size()) {
    for_each_index(states.size(),
                   [&](std::size_t s) { references_[s] = maker_.estimate(states[s]); });
  }

  /// Whether function `i` may exceed its bound at some state. A bound that is too narrow is widened
  /// by the interpreter's errors at further states.
  bool is_suspect(std::size_t i) {
    Bound bound;
    std::vector<bool> is_known(references_.size(), false);
    while (const auto open = find_open(i, bound, is_known)) learn(i, *open, bound, is_known);
    while (leaves_bound(i, bound, is_known)) {
      const auto next = find_unknown(i, is_known);
      if (!next) return true;
      learn(i, *next, bound, is_known);
    }
    return false;
  }

 private:
  /// Computes the 50 digits of function `i` at state `s` and widens the bound by what they show.
  void learn(std::size_t i, std::size_t s, Bound& bound, std::vector<bool>& is_known) {
    FunctionReference& at = references_[s].functions[i];
    maker_.complete(i, references_[s].state, at);
    is_known[s] = true;
    const double own = at.interpreter_error / at.amplification;
    if (own <= std::numeric_limits<double>::max()) {
      bound.interpreter = std::max(bound.interpreter, own);
    }
  }

  /// Finds a state at which function `i` has a value whose 50 digits were not computed.
  std::optional<std::size_t> find_unknown(std::size_t i, const std::vector<bool>& is_known) const {
    for (std::size_t s = 0; s < references_.size(); ++s) {
      const FunctionReference& at = references_[s].functions[i];
      if (!is_known[s] && !at.singular && !at.graph.empty()) return s;
    }
    return std::nullopt;
  }

  /// Finds, among the states without 50 digits, the one that is farthest beyond what can be
  /// accepted without them. The graph's error is at most its distance d from the interpreter in
  /// Real plus the interpreter's own error e. The bound is at least 8 ulp, at least 16 e, and at
  /// least 16 times the error that the interpreter's errors at other states predict here. An eighth
  /// is kept in reserve because the scales come from the interpreter in Real.
  std::optional<std::size_t> find_open(std::size_t i, const Bound& bound,
                                       const std::vector<bool>& is_known) const {
    constexpr double kKept = 7.0 / 8;
    std::optional<std::size_t> open;
    double largest = kKept;
    for (std::size_t s = 0; s < references_.size(); ++s) {
      const FunctionReference& at = references_[s].functions[i];
      if (is_known[s] || at.singular || at.graph.empty()) continue;
      const double share = error_in_ulp(at.graph, at, unit_) / bound.at(at);
      if (share <= largest) continue;
      largest = share;
      open = s;
    }
    return open;
  }

  bool leaves_bound(std::size_t i, const Bound& bound, const std::vector<bool>& is_known) const {
    for (std::size_t s = 0; s < references_.size(); ++s) {
      const FunctionReference& at = references_[s].functions[i];
      if (at.singular && at.stays_finite && !are_finite(at.graph)) return true;
      if (is_known[s] && error_in_ulp(at.graph, at, unit_) > bound.at(at)) return true;
    }
    return false;
  }

  const ReferenceMaker& maker_;
  double unit_;
  std::vector<StateReference> references_;
};

/// Finds the functions that may exceed their bounds at these states.
std::vector<GeneratedFunction> find_suspects(const Robot& robot, const Scene& scene,
                                             const ChosenFunctions& chosen,
                                             const std::vector<int>& states, std::uint64_t seed) {
  const ReferenceMaker maker(robot, scene, chosen, seed);
  Trial trial(maker, states, unit_of(scene.real));
  std::vector<char> suspect(maker.functions().size());
  for_each_index(suspect.size(), [&](std::size_t i) { suspect[i] = trial.is_suspect(i) ? 1 : 0; });
  std::vector<GeneratedFunction> suspects;
  for (std::size_t i = 0; i < suspect.size(); ++i) {
    if (suspect[i] != 0) suspects.push_back(maker.functions()[i]);
  }
  return suspects;
}

/// Finds the functions that exceed their bounds at the first `states` states, using 50 digits
/// everywhere.
std::vector<FailedTrial> find_failed(const Robot& robot, const Scene& scene,
                                     const ChosenFunctions& chosen, int states,
                                     std::uint64_t seed) {
  ReferenceOptions options;
  options.states = states;
  options.seed = seed;
  const auto references = make_references(robot, scene, chosen, options);
  const std::vector<GeneratedFunction> functions = all_callable(chosen);
  std::vector<FailedTrial> failed;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    auto found = judge(i, functions[i], references, unit_of(scene.real));
    if (found) failed.push_back(std::move(*found));
  }
  return failed;
}

}  // namespace

std::vector<FailedTrial> try_functions(const Robot& robot, const Scene& scene,
                                       const ChosenFunctions& chosen, const TrialOptions& options) {
  const auto at_few = find_suspects(robot, scene, chosen, options.states, options.seed);
  if (at_few.empty()) return {};
  const ChosenFunctions doubted = keep(chosen, functions_of(at_few));
  std::vector<int> states(static_cast<std::size_t>(options.confirm));
  std::iota(states.begin(), states.end(), 0);
  const auto suspects = find_suspects(robot, scene, doubted, states, options.seed);
  if (suspects.empty()) return {};
  std::vector<FailedTrial> failed = find_failed(robot, scene, keep(chosen, functions_of(suspects)),
                                                options.confirm, options.seed);
  std::erase_if(failed, [&](const FailedTrial& each) {
    return std::none_of(at_few.begin(), at_few.end(), [&](const GeneratedFunction& suspect) {
      return each.name == source_stem(suspect);
    });
  });
  return failed;
}

}  // namespace treeline
