#include "emission/cpp/print_limited.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "emission/comment.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/limit_cost.hpp"
#include "emission/wrap_line.hpp"
#include "passes/count_operations.hpp"

namespace treeline::cpp {
namespace {

const Program& find_program(std::span<const Program> programs, const std::string& name) {
  const auto found = std::find_if(programs.begin(), programs.end(),
                                  [&](const Program& each) { return each.name == name; });
  if (found == programs.end()) throw std::logic_error("limited lacks " + name);
  return *found;
}

bool holds_rows(const EmissionContext& context) {
  return !context.limits->force_weights.empty();
}

/// `name(a, b, results);`
std::string print_call(const Program& program, const std::string& results) {
  std::string list;
  for (const Argument& argument : program.arguments) list += argument.name + ", ";
  return fmt::format("{}({}{});", program.name, list, results);
}

std::string print_signature(const EmissionContext& context, const Program& supported) {
  std::string list;
  for (const Argument& argument : supported.arguments) {
    list += fmt::format("const Real (&{})[{}], ", argument.name, argument.rows * argument.cols);
  }
  list += fmt::format("Real (&tau)[{}], ", context.velocities);
  if (holds_rows(context)) {
    list += fmt::format("Real (&f)[{}], ", context.limits->force_weights.size());
  }
  return fmt::format(
      "inline void limited_control_torque({}LimitedTorque& limited, "
      "const TorqueLimits& limits = kTorqueLimits) noexcept {{",
      list);
}

template <class Number, class Print>
std::string print_list(const std::vector<Number>& numbers, const Print& print) {
  std::string list;
  for (const Number& number : numbers) list += (list.empty() ? "" : ", ") + print(number);
  return "{" + (list.empty() ? print(Number{}) : list) + "}";
}

std::string print_matrices(const EmissionContext& context, std::span<const Program> programs) {
  std::string calls = print_call(find_program(programs, "mass_matrix"), "M");
  calls += holds_rows(context)
               ? "\n" + print_call(find_program(programs, "constraint_jacobian"), "J_s")
               : "\n(void)J_s;";
  calls += context.task_rows > 0 ? "\n" + print_call(find_program(programs, "jacobian"), "J_t")
                                 : "\n(void)J_t;";
  return calls;
}

std::string print_limits(const EmissionContext& context) {
  const Syntax syntax = make_syntax(context);
  const auto literal = [&](double x) {
    return std::isfinite(x) ? syntax.literal(x) : std::string("detail::kNoLimit<Real>");
  };
  const LimitFacts& facts = *context.limits;
  std::string cones;
  for (const LimitFacts::Row& row : facts.cones) {
    std::vector<double> coefficients = row.coefficients;
    coefficients.resize(6);
    cones +=
        fmt::format("{}{{{}, {}, {}, {}}}", cones.empty() ? "" : ", ", row.first,
                    row.coefficients.size(), print_list(coefficients, literal), literal(row.bound));
  }
  if (cones.empty()) cones = "{}";
  return wrap_line(fmt::format("inline constexpr TorqueLimits kTorqueLimits = {{{}, {{{}}}, {}}};",
                               print_list(facts.torque, literal), cones,
                               print_list(facts.task_weights, literal)),
                   0);
}

int freedoms_of(const LimitFacts& facts) {
  return std::max(facts.freedoms, 1);
}

std::string describe_cost(const EmissionContext& context, std::span<const Program> programs) {
  const LimitFacts& facts = *context.limits;
  const LimitCost cost = cost_of_limits(facts, context.velocities);
  const int flops = count_operations(find_program(programs, "supported_control_torque")).flops();
  return wrap_text(
      fmt::format("Cost: {} flops where no limit is reached. Else a quadratic program of {} "
                  "unknowns and {} rows: at most {} steps of at most {} flops.",
                  flops, cost.unknowns, cost.rows, cost.iterations, cost.flops_of_iteration),
      95);
}

std::string describe_cones(const LimitFacts& facts) {
  std::string text;
  for (const std::string& note : facts.notes) {
    text += (text.empty() ? "" : "\n") + wrap_text(note + ".", 95);
  }
  return text.empty() ? "No forces are limited." : text;
}

std::string print_layout(const EmissionContext& context) {
  const Syntax syntax = make_syntax(context);
  const LimitFacts& facts = *context.limits;
  return wrap_line(
      fmt::format("inline constexpr detail::SupportLayout<Real, LimitSizes> kSupportLayout = "
                  "{{{}, {}}};",
                  print_list(facts.passive, [](int each) { return std::to_string(each); }),
                  print_list(facts.force_weights, [&](double x) { return syntax.literal(x); })),
      0);
}

}  // namespace

std::string print_limited(const EmissionContext& context, std::span<const Program> programs) {
  const LimitFacts& facts = *context.limits;
  const Program& supported = find_program(programs, "supported_control_torque");
  const std::string sizes =
      fmt::format("using LimitSizes = detail::LimitSizes<{}, {}, {}, {}, {}, {}>;",
                  context.velocities, facts.passive.size(), facts.force_weights.size(),
                  context.task_rows, facts.cones.size(), freedoms_of(facts));
  const std::string without = holds_rows(context) ? "" : "Real f[1] = {};\n";
  return fill_template(
      templates::kLimited,
      {{"robot", context.robot},
       {"name", context.name},
       {"sizes", wrap_line(sizes, 0)},
       {"layout", print_layout(context)},
       {"notes", comment("///", describe_cones(facts))},
       {"limits", print_limits(context)},
       {"cost", comment("///", describe_cost(context, programs))},
       {"signature", wrap_line(print_signature(context, supported), 0)},
       {"supported", without + print_call(supported, holds_rows(context) ? "tau, f" : "tau")},
       {"matrices", print_matrices(context, programs)}});
}

}  // namespace treeline::cpp
