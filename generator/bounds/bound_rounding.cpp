#include "bounds/bound_rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bounds/bound_sets.hpp"

namespace treeline {
namespace {

/// Which divisor it is, by the name that emitted code gives it.
std::string describe_division(const Graph& graph, std::uint32_t division) {
  const auto name = graph.names().find(graph.nodes()[division].b);
  return fmt::format("it divides by {} of which no least magnitude is known",
                     name == graph.names().end() ? "a value" : name->second);
}

/// Two digits, never less than the value.
std::string rounded_up(double value) {
  if (value == 0) return "0";
  const double last = std::pow(10, std::floor(std::log10(value)) - 1);
  return fmt::format("{:.1e}", std::ceil(value / last * (1 - 1e-12)) * last);
}

}  // namespace

RoundingBound bound_rounding(const Program& program, const Domain& domain, double unit) {
  RoundingBound bound;
  bound.missing.clear();
  bounds::InputSizes sizes;
  for (const std::string& input : program.graph.inputs()) {
    const auto size = domain.find(input);
    if (!size) {
      bound.missing = fmt::format("no range is stated for {}", input);
      return bound;
    }
    sizes.push_back(*size);
  }
  const bounds::SetBounds sets(program.graph, std::move(sizes), unit);
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      if (const auto division = sets.division_below(value.node())) {
        return {describe_division(program.graph, *division), {}, {}};
      }
      const bounds::Bounded entry = *sets.of(value.node());
      bound.size.push_back(entry.size);
      bound.error.push_back(entry.error * unit);
    }
  }
  return bound;
}

std::string describe(const RoundingBound& bound, const Program& program, double unit) {
  if (!bound.exists()) return "no bound is known: " + bound.missing;
  std::string text;
  auto error = bound.error.begin();
  auto size = bound.size.begin();
  for (const Result& result : program.results) {
    const auto count = static_cast<std::ptrdiff_t>(result.values.size());
    const auto worst = std::max_element(error, error + count) - error;
    const double largest = *std::max_element(size, size + count);
    const std::string& name = result.argument.name;
    text += text.empty() ? "" : "; ";
    text += largest == 0
                ? fmt::format("none in {}", name)
                : fmt::format(
                      "at most {} in {} (at {}[{}]), {:.0f} ulp of {}, the most that {} "
                      "can be",
                      rounded_up(error[worst]), name, name, worst,
                      std::ceil(error[worst] / (2 * unit * largest)), rounded_up(largest), name);
    error += count;
    size += count;
  }
  return text;
}

}  // namespace treeline
