#include "emission/cpp/print_limited.hpp"

#include <fmt/format.h>

#include "emission/comment.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_limited.hpp"
#include "emission/fill_template.hpp"
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
  return wrap_line(fmt::format("inline constexpr TorqueLimits kTorqueLimits = {{{}}};",
                               print_torque_limits(*context.limits, make_syntax(context),
                                                   "detail::kNoLimit<Real>", "{}")),
                   0);
}

std::string print_layout(const EmissionContext& context) {
  return wrap_line(
      fmt::format("inline constexpr detail::SupportLayout<Real, LimitSizes> kSupportLayout = "
                  "{{{}}};",
                  print_support_layout(*context.limits, make_syntax(context))),
      0);
}

}  // namespace

std::string print_limited(const EmissionContext& context, std::span<const Program> programs) {
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
