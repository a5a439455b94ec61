#include "bounds/bound_rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bounds/bound_sets.hpp"
#include "bounds/quaternion_scale.hpp"
#include "text/round_outward.hpp"

namespace treeline {
namespace {

double ulps(double error, double unit, double size) {
  return std::ceil(error / (2 * unit * size));
}

std::optional<std::string> missing_range(const Program& program, const Domain& domain) {
  for (const std::string& input : program.graph.inputs()) {
    if (!domain.find(input)) return input;
  }
  return std::nullopt;
}

/// Whether the graph has a division whose divisor may be zero.
bool divides(const Graph& graph) {
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    if (graph.nodes()[i].op == Op::div && !bounds::is_quaternion_scale(graph, i)) return true;
  }
  return false;
}

RoundingBound no_bound(std::string why) {
  RoundingBound none;
  none.missing = std::move(why);
  return none;
}

RoundingBound prove(const Program& program, const Domain& domain, double unit) {
  bounds::InputSizes sizes;
  for (const std::string& input : program.graph.inputs()) sizes.push_back(*domain.find(input));
  const bounds::SetBounds sets(program.graph, std::move(sizes), unit);
  RoundingBound bound;
  bound.kind = RoundingBound::Kind::proven;
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      const bounds::Bounded entry = *sets.of(value.node());
      if (!std::isfinite(entry.size + entry.error)) {
        return no_bound("numbers may be too large to be represented");
      }
      bound.size.push_back(entry.size);
      bound.error.push_back(entry.error * unit);
    }
  }
  return bound;
}

RoundingBound search(const Program& program, const Domain& domain, double unit) {
  RoundingBound bound;
  bound.kind = RoundingBound::Kind::searched;
  bound.worst = bounds::search_worst(program, domain, unit, bounds::default_effort(program.graph));
  for (bounds::FoundError& found : bound.worst) {
    found.error *= kSearchMargin * unit;
    if (found.error > found.size) return no_bound("no digit may be left");
  }
  return bound;
}

RoundingBound look_at_states(const Program& program, const Domain& domain, double unit) {
  RoundingBound bound;
  bound.kind = RoundingBound::Kind::typical;
  bound.at_states =
      bounds::find_typical(program, domain, unit, bounds::default_effort(program.graph));
  for (bounds::TypicalErrors& errors : bound.at_states) {
    for (bounds::FoundError& found : errors) found.error *= unit;
  }
  return bound;
}

std::string describe_proven(const RoundingBound& bound, const Program& program, double unit) {
  std::string text;
  auto error = bound.error.begin();
  auto size = bound.size.begin();
  for (const Result& result : program.results) {
    const auto count = static_cast<std::ptrdiff_t>(result.values.size());
    const auto worst = std::max_element(error, error + count) - error;
    const double largest = *std::max_element(size, size + count);
    const std::string& name = result.argument.name;
    text += text.empty() ? "" : "; ";
    text += largest == 0 ? fmt::format("none in {}", name)
                         : fmt::format(
                               "at most {} in {} (at {}[{}]), {:.0f} ulp of {}, the most "
                               "that {} can be",
                               rounded_up(error[worst], 2), name, name, worst,
                               ulps(error[worst], unit, largest), rounded_up(largest, 2), name);
    error += count;
    size += count;
  }
  return text;
}

std::string describe_searched(const RoundingBound& bound, const Program& program, double unit) {
  std::string text;
  for (std::size_t r = 0; r < program.results.size(); ++r) {
    const std::string& name = program.results[r].argument.name;
    const bounds::FoundError& worst = bound.worst[r];
    text += text.empty() ? "" : "; ";
    text += worst.error == 0
                ? fmt::format("none in {}", name)
                : fmt::format("at most {} in {} (at {}[{}]), {:.0f} ulp of {}",
                              rounded_up(worst.error, 1), name, name, worst.entry,
                              ulps(worst.error, unit, worst.size), rounded_up(worst.size, 1));
  }
  return text + fmt::format(", to first order, {} times what a search met", kSearchMargin);
}

std::string describe_typical(const RoundingBound& bound, const Program& program, double unit) {
  std::string text = "in 50, 90, 99 of 100 states, to first order, at most ";
  for (std::size_t r = 0; r < program.results.size(); ++r) {
    std::string at_states;
    for (const bounds::FoundError& found : bound.at_states[r]) {
      at_states += at_states.empty() ? "" : ", ";
      at_states += found.error == 0 ? "nothing"
                                    : fmt::format("{} ({:g} ulp of {})", rounded_up(found.error, 1),
                                                  round_up(ulps(found.error, unit, found.size), 1),
                                                  rounded_up(found.size, 1));
    }
    text +=
        fmt::format("{}{} in {}", r == 0 ? "" : "; ", at_states, program.results[r].argument.name);
  }
  return text + "; more towards singularities";
}

}  // namespace

RoundingBound bound_rounding(const Program& program, const Domain& domain, double unit,
                             Solve solve) {
  if (const auto input = missing_range(program, domain)) {
    return no_bound(fmt::format("no range is stated for {}", *input));
  }
  if (!divides(program.graph)) return prove(program, domain, unit);
  return solve == Solve::lambda_inverse ? look_at_states(program, domain, unit)
                                        : search(program, domain, unit);
}

std::string describe(const RoundingBound& bound, const Program& program, double unit) {
  switch (bound.kind) {
    case RoundingBound::Kind::proven:
      return describe_proven(bound, program, unit);
    case RoundingBound::Kind::searched:
      return describe_searched(bound, program, unit);
    case RoundingBound::Kind::typical:
      return describe_typical(bound, program, unit);
    case RoundingBound::Kind::none:
      break;
  }
  return "no bound is known: " + bound.missing;
}

}  // namespace treeline
