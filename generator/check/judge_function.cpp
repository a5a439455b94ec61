#include "check/judge_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "program/evaluate.hpp"

namespace treeline {
namespace {

/// Equal numbers with equal signs, or both not a number.
bool same_bits(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

void note_bits(const CallResult& result, const StateReference& reference,
               const FunctionReference& function, FunctionReport& report) {
  const bool same = std::equal(result.entries.begin(), result.entries.end(), function.graph.begin(),
                               function.graph.end(), same_bits);
  report.out_of_bounds += result.wrote_out_of_bounds ? 1 : 0;
  if (same) return;
  if (report.bits_differ++ == 0) report.first_bits_differ = reference.state.index;
}

void note_error(const ErrorAt& found, FunctionReport& report, std::vector<double>& errors) {
  const bool first = errors.empty();
  errors.push_back(found.error);
  report.beyond_bound += found.error <= found.bound ? 0 : 1;
  if (first || found.error > report.worst.error) report.worst = found;
  if (first || found.error / found.bound > report.nearest.error / report.nearest.bound) {
    report.nearest = found;
  }
}

/// Holds the errors in a state of the domain to what was proven of them: against the graph in long
/// double, whose own errors are of no account.
void note_rounding(const CallResult& result, const StateReference& reference,
                   const GeneratedFunction& generated, const Domain& domain,
                   FunctionReport& report) {
  if (!report.proven) return;
  const Program& program = generated.program;
  std::vector<std::vector<long double>> arguments;
  for (const auto* argument : arguments_of(program, reference.state)) {
    if (!domain.contains(program.arguments[arguments.size()].name, *argument)) return;
    arguments.emplace_back(argument->begin(), argument->end());
  }
  std::size_t i = 0;
  for (const auto& entries : evaluate<long double>(program, arguments)) {
    for (const long double exact : entries) {
      const auto error = static_cast<double>(std::abs(exact - result.entries[i]));
      const double share = error == 0 ? 0 : error / generated.rounding.error[i];
      report.proven->used = std::max(
          report.proven->used, std::isnan(share) ? std::numeric_limits<double>::infinity() : share);
      ++i;
    }
  }
  ++report.proven->states;
}

FunctionReport begin_report(const GeneratedFunction& generated) {
  FunctionReport report;
  report.name = source_stem(generated);
  report.method = generated.chosen.method;
  report.count = count_operations(generated.program);
  if (generated.rounding.exists() && !generated.rounding.error.empty()) {
    const std::vector<double>& errors = generated.rounding.error;
    report.proven.emplace().error = *std::max_element(errors.begin(), errors.end());
  }
  return report;
}

}  // namespace

FunctionReport judge_function(std::size_t i, const GeneratedFunction& generated,
                              const std::vector<StateReference>& references, Real real,
                              const Domain& domain, const GeneratedLibrary& accurate,
                              const GeneratedLibrary& exact) {
  FunctionReport report = begin_report(generated);
  report.bound = find_bound(i, generated.function, references);
  std::vector<double> errors;
  for (const StateReference& reference : references) {
    const FunctionReference& function = reference.functions[i];
    ++report.states;
    const CallResult result = accurate.call(i, reference.state);
    note_bits(&accurate == &exact ? result : exact.call(i, reference.state), reference, function,
              report);
    if (function.singular) {
      ++report.singular;
      continue;
    }
    note_rounding(result, reference, generated, domain, report);
    report.interpreter_worst = std::max(report.interpreter_worst, function.interpreter_error);
    note_error({reference.state.index, error_in_ulp(result.entries, function, unit_of(real)),
                report.bound.at(function), function.condition},
               report, errors);
  }
  report.median = quantile(errors, 0.5);
  report.percent_99 = quantile(errors, 0.99);
  return report;
}

Bound find_bound(std::size_t i, Function function, const std::vector<StateReference>& references) {
  Bound bound;
  bound.solve = solve_of(function);
  for (const StateReference& reference : references) {
    const FunctionReference& at = reference.functions[i];
    const double error = at.interpreter_error / at.condition;
    // An interpreter that fails says nothing about what to allow.
    if (!at.singular && std::isfinite(error)) {
      bound.interpreter = std::max(bound.interpreter, error);
    }
  }
  return bound;
}

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace treeline
