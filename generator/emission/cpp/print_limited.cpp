#include "emission/cpp/print_limited.hpp"

#include <fmt/format.h>

#include <map>

#include "emission/c/print_limited.hpp"
#include "emission/comment.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_limited.hpp"
#include "emission/fill_template.hpp"
#include "emission/misra/templates.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::cpp {
namespace {

/// `name(a, b, results);`
std::string print_call(const Program& program, const std::string& results) {
  std::string list;
  for (const Argument& argument : program.arguments) list += argument.name + ", ";
  return fmt::format("{}({}{});", program.name, list, results);
}

/// `states` is "[kStates]" of a batch, else empty; `limited` the parameter of that name.
std::string print_signature(const EmissionContext& context, const Program& supported,
                            const char* states, const char* limited) {
  std::string list;
  for (const Argument& argument : supported.arguments) {
    list += fmt::format("const Real (&{})[{}]{}, ", argument.name, argument.rows * argument.cols,
                        states);
  }
  list += fmt::format("Real (&tau)[{}]{}, ", context.velocities, states);
  if (holds_rows(context)) {
    list += fmt::format("Real (&f)[{}]{}, ", context.limits->force_weights.size(), states);
  }
  return fmt::format(
      "inline void limited_control_torque({}{}, const TorqueLimits& limits = kTorqueLimits) "
      "noexcept {{",
      list, limited);
}

/// The call of the unlimited law. Without held rows f has one entry that nothing reads.
std::string print_supported(const EmissionContext& context, const Program& supported,
                            const char* states) {
  if (holds_rows(context)) return print_call(supported, "tau, f");
  return fmt::format("Real f[1]{} = {{}};\n", states) + print_call(supported, "tau");
}

std::string print_matrices(const EmissionContext& context, std::span<const Program> programs) {
  std::string text;
  for (const LimitedCall& call : list_limited_calls(context, programs)) {
    text += print_call(*call.program, call.result) + "\n";
  }
  if (!holds_rows(context)) text += "(void)J_s;\n";
  if (context.task_rows == 0) text += "(void)J_t;\n";
  text.pop_back();
  return text;
}

std::string print_limits(const EmissionContext& context) {
  const Syntax syntax = make_syntax(context);
  const std::string none = context.misra ? syntax.literal(1e30) : "detail::kNoLimit<Real>";
  return wrap_line(fmt::format("inline constexpr TorqueLimits kTorqueLimits = {{{}}};",
                               print_torque_limits(*context.limits, syntax, none, "{}")),
                   0);
}

std::string print_layout(const EmissionContext& context) {
  return wrap_line(
      fmt::format("inline constexpr detail::SupportLayout<Real, LimitSizes> kSupportLayout = "
                  "{{{}}};",
                  print_support_layout(*context.limits, make_syntax(context))),
      0);
}

/// By a loop: of an initialiser compilers make a call of memset.
std::string print_zeros(const EmissionContext& context, const char* array,
                        const std::string& size) {
  return fmt::format("for (int32_t i = 0; i < {}; ++i) {{\n  {}[i] = {};\n}}\n", size, array,
                     make_syntax(context).literal(0));
}

/// By the loops of C, for `profile: misra`.
std::string print_safe_limited(const EmissionContext& context, std::span<const Program> programs) {
  auto holes = c::list_limit_holes(context, context.name, "");
  std::string matrices;
  for (const LimitedCall& call : list_limited_calls(context, programs)) {
    matrices += print_call(*call.program, call.result) + "\n";
  }
  if (!holds_rows(context)) matrices += print_zeros(context, "J_s", holes["held_entries"]);
  if (context.task_rows == 0) matrices += print_zeros(context, "J_t", holes["task_entries"]);
  holes["notes"] = comment("///", describe_cones(*context.limits));
  holes["limits"] = print_limits(context);
  holes["cost"] = comment("///", describe_limited_cost(context, programs));
  holes["signature"] = wrap_line(
      print_signature(context, find_supported(programs), "", "LimitedTorque& limited"), 0);
  holes["supported"] = print_supported(context, find_supported(programs), "");
  holes["matrices"] = matrices;
  return c::fill_limits(misra::templates::kLimited, holes);
}

}  // namespace

std::string print_limited(const EmissionContext& context, std::span<const Program> programs) {
  if (context.misra) return print_safe_limited(context, programs);
  const LimitFacts& facts = *context.limits;
  const Program& supported = find_supported(programs);
  const std::string sizes =
      fmt::format("using LimitSizes = detail::LimitSizes<{}, {}, {}, {}, {}, {}>;",
                  context.velocities, facts.passive.size(), facts.force_weights.size(),
                  context.task_rows, facts.cones.size(), count_freedoms(facts));
  return fill_template(
      templates::kLimited,
      {{"robot", context.robot},
       {"name", context.name},
       {"sizes", wrap_line(sizes, 0)},
       {"layout", print_layout(context)},
       {"notes", comment("///", describe_cones(facts))},
       {"limits", print_limits(context)},
       {"cost", comment("///", describe_limited_cost(context, programs))},
       {"signature",
        wrap_line(print_signature(context, supported, "", "LimitedTorque& limited"), 0)},
       {"supported", print_supported(context, supported, "")},
       {"matrices", print_matrices(context, programs)}});
}

std::string print_batch_limited(const EmissionContext& context, std::span<const Program> batch) {
  const Program& supported = find_supported(batch);
  return fill_template(
      templates::kBatchLimited,
      {{"robot", context.robot},
       {"name", context.name},
       {"states", std::to_string(context.batch)},
       {"cost", comment("///", describe_batch_limited_cost(context, batch))},
       {"signature", wrap_line(print_signature(context, supported, "[kStates]",
                                               "LimitedTorque (&limited)[kStates]"),
                               0)},
       {"supported", print_supported(context, supported, "[kStates]")},
       {"matrices", print_matrices(context, batch)}});
}

}  // namespace treeline::cpp
