#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "bounds/lie_on_circle.hpp"
#include "bounds/propagate_errors.hpp"
#include "check/judges.hpp"
#include "program/evaluate.hpp"

namespace treeline {
namespace {

using bounds::kStatesAtOnce;
using bounds::States;

/// Second-order errors are smaller than first-order ones by the factor condition times unit. It
/// must not exceed this.
constexpr double kFirstOrder = 1e-4;
/// Number of entries of each result that are compared with a first-order bound, those with the
/// largest errors. Each costs a pass over the graph.
constexpr std::size_t kEntries = 16;

/// Error divided by bound; infinite if one of them is not a number.
double share_of(double error, double bound) {
  const double share = error == 0 ? 0 : error / bound;
  return std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
}

/// Errors of all entries of all results.
std::vector<double> errors_of(const Program& program, const Call& call) {
  std::vector<std::vector<long double>> arguments;
  for (const auto* argument : arguments_of(program, *call.state)) {
    arguments.emplace_back(argument->begin(), argument->end());
  }
  std::vector<double> errors;
  for (const auto& entries : evaluate<long double>(program, arguments)) {
    for (const long double exact : entries) {
      errors.push_back(static_cast<double>(std::abs(exact - call.result.entries[errors.size()])));
    }
  }
  return errors;
}

bool lies_in(const Domain& domain, const Program& program, const State& state, double unit) {
  const std::vector<double>* sines = nullptr;
  std::size_t i = 0;
  for (const auto* argument : arguments_of(program, state)) {
    const std::string& name = program.arguments[i++].name;
    if (!domain.contains(name, *argument)) return false;
    if (name == symbol_of(Quantity::sin_q)) sines = argument;
    if (name == symbol_of(Quantity::cos_q) && !lie_on_circle(*sines, *argument, unit)) return false;
  }
  return true;
}

void hold_to_proven(const GeneratedFunction& generated, const Domain& domain, double unit,
                    const Call& call, RoundingReport& report) {
  if (!lies_in(domain, generated.program, *call.state, unit)) return;
  const std::vector<double> errors = errors_of(generated.program, call);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    report.used = std::max(report.used, share_of(errors[i], generated.rounding.error[i]));
  }
  ++report.states;
}

/// Compares errors with first-order bounds, at as many states as are propagated together. The last
/// state fills unused places.
class FirstOrder {
 public:
  FirstOrder(const Program& program, double unit)
      : program_(program), places_(locate_inputs(program)), propagation_(program.graph, unit) {}

  /// Largest ratio of an error to its bound.
  double share(std::span<const Call> calls, double unit) {
    evaluate(calls);
    std::vector<std::vector<double>> errors;
    for (const Call& call : calls) errors.push_back(errors_of(program_, call));
    double share = 0;
    std::size_t first = 0;
    for (const Result& result : program_.results) {
      for (const std::size_t i : largest(errors, first, result.values.size())) {
        const States& bound = propagation_.bound(result.values[i - first].node());
        for (std::size_t s = 0; s < calls.size(); ++s) {
          share = std::max(share, share_of(errors[s][i], unit * (bound[s] + calls[s].sizes[i])));
        }
      }
      first += result.values.size();
    }
    return share;
  }

 private:
  void evaluate(std::span<const Call> calls) {
    std::vector<States> inputs(places_.size());
    for (std::size_t s = 0; s < kStatesAtOnce; ++s) {
      const auto arguments = arguments_of(program_, *calls[std::min(s, calls.size() - 1)].state);
      for (std::size_t i = 0; i < places_.size(); ++i) {
        inputs[i][s] = (*arguments[places_[i].argument])[places_[i].element];
      }
    }
    propagation_.evaluate(inputs);
  }

  /// Indices of a result's entries with the largest errors, counted over all results. The result
  /// has `count` entries, beginning with `first`.
  static std::vector<std::size_t> largest(const std::vector<std::vector<double>>& errors,
                                          std::size_t first, std::size_t count) {
    std::vector<double> most(count, 0);
    std::vector<std::size_t> entries;
    for (std::size_t i = 0; i < count; ++i) {
      entries.push_back(first + i);
      for (const auto& each : errors) most[i] = std::max(most[i], each[first + i]);
    }
    std::stable_sort(entries.begin(), entries.end(), [&](std::size_t a, std::size_t b) {
      return most[a - first] > most[b - first];
    });
    entries.resize(std::min(entries.size(), kEntries));
    return entries;
  }

  const Program& program_;
  std::vector<InputPlace> places_;
  bounds::ErrorPropagation propagation_;
};

void hold_to_first_order(const Program& program, double unit, const std::vector<Call>& calls,
                         RoundingReport& report) {
  std::vector<Call> sound;
  for (const Call& call : calls) {
    if (call.condition * unit <= kFirstOrder) sound.push_back(call);
  }
  FirstOrder propagation(program, unit);
  for (std::size_t i = 0; i < sound.size(); i += kStatesAtOnce) {
    const auto at_once = std::span(sound).subspan(i, std::min(kStatesAtOnce, sound.size() - i));
    report.used = std::max(report.used, propagation.share(at_once, unit));
  }
  report.states = static_cast<int>(sound.size());
}

/// Largest error that is stated for any result; for typical errors the one in 99 of 100 states.
double stated_error(const RoundingBound& rounding) {
  double error = 0;
  for (const double each : rounding.error) error = std::max(error, each);
  for (const bounds::FoundError& worst : rounding.worst) error = std::max(error, worst.error);
  for (const auto& at : rounding.at_states) error = std::max(error, at.back().error);
  return error;
}

}  // namespace

std::optional<RoundingReport> judge_rounding(const GeneratedFunction& generated,
                                             const Domain& domain, double unit,
                                             const std::vector<Call>& calls) {
  if (generated.rounding.kind == RoundingBound::Kind::none) return std::nullopt;
  RoundingReport report{generated.rounding.kind, stated_error(generated.rounding)};
  if (generated.rounding.is_first_order()) {
    hold_to_first_order(generated.program, unit, calls, report);
  } else {
    for (const Call& call : calls) hold_to_proven(generated, domain, unit, call, report);
  }
  return report;
}

}  // namespace treeline
