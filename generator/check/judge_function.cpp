#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "check/judges.hpp"

namespace treeline {
namespace {

/// Whether two results of loops, or of a routine behind lines, agree. Their graph has no products
/// with constants of 0, which code multiplies: the sign of a zero may differ.
bool same_or_zero(double code, double graph) {
  return same_bits(code, graph) || (code == 0 && graph == 0);
}

/// Whether results agree of a function that is singular at the state. Where a pivot is 0, 0 times
/// infinity is NaN in code alone.
bool same_where_singular(double code, double graph) {
  return same_or_zero(code, graph) || std::isnan(code);
}

void note_bits(const GeneratedFunction& generated, const CallResult& result,
               const StateReference& reference, const FunctionReference& function,
               FunctionReport& report) {
  report.bits_known = report.bits_known && !function.graph.empty();
  const bool same = are_bits_of_graph(generated, result.entries, function);
  report.out_of_bounds += result.wrote_out_of_bounds ? 1 : 0;
  if (same || !report.bits_known) return;
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

FunctionReport begin_report(const GeneratedFunction& generated) {
  FunctionReport report;
  report.name = source_stem(generated);
  report.method = describe(generated.chosen.route);
  if (!is_composed(generated)) report.count = count_operations(generated.program);
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
  std::vector<Call> calls;
  for (const StateReference& reference : references) {
    const FunctionReference& function = reference.functions[i];
    ++report.states;
    CallResult result = accurate.call(i, reference.state);
    note_bits(generated, &accurate == &exact ? result : exact.call(i, reference.state), reference,
              function, report);
    if (function.singular && function.stays_finite && !are_finite(result.entries)) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      note_error({reference.state.index, kInfinity, Bound::kFloorUlp, function.condition,
                  function.amplification},
                 report, errors);
      continue;
    }
    if (function.singular) {
      ++report.singular;
      continue;
    }
    report.interpreter_worst = std::max(report.interpreter_worst, function.interpreter_error);
    note_error({reference.state.index, error_in_ulp(result.entries, function, unit_of(real)),
                report.bound.at(function), function.condition, function.amplification},
               report, errors);
    calls.push_back({&reference.state, function.condition, function.size, std::move(result)});
  }
  report.rounding = judge_rounding(generated, domain, unit_of(real) / 2, calls);
  report.median = quantile(errors, 0.5);
  report.percent_99 = quantile(errors, 0.99);
  return report;
}

bool same_bits(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

bool are_bits_of_graph(const GeneratedFunction& generated, const std::vector<double>& results,
                       const FunctionReference& reference) {
  const Program& program = generated.program;
  const bool loops = program.loops != nullptr || program.ending != nullptr;
  return std::equal(results.begin(), results.end(), reference.graph.begin(), reference.graph.end(),
                    !loops               ? same_bits
                    : reference.singular ? same_where_singular
                                         : same_or_zero);
}

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace treeline
