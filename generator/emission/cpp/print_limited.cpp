#include <fmt/format.h>

#include <map>

#include "emission/c/print_files.hpp"
#include "emission/comment.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"

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

/// By a loop: of an initialiser compilers make a call of memset. `states` is a factor of `size`.
std::string print_zeros(const EmissionContext& context, const char* array, int size,
                        const char* states) {
  const std::string place = *states == '\0' ? "[i]" : "[i][k]";
  const std::string zero = fmt::format("{}{} = {};", array, place, make_syntax(context).literal(0));
  if (*states == '\0') {
    return fmt::format("for (int32_t i = 0; i < {}; ++i) {{\n  {}\n}}\n", size, zero);
  }
  return fmt::format(
      "for (int32_t i = 0; i < {}; ++i) {{\n  for (int32_t k = 0; k < kStates; ++k) {{\n    "
      "{}\n  }}\n}}\n",
      size, zero);
}

/// The call of the unlimited law. Without held rows f has one entry that nothing reads.
std::string print_supported(const EmissionContext& context, const Program& supported,
                            const char* states) {
  if (holds_rows(context)) return print_call(supported, "tau, f");
  return fmt::format("Real f[1]{};\n", states) + print_zeros(context, "f", 1, states) +
         print_call(supported, "tau");
}

std::string print_matrices(const EmissionContext& context, std::span<const Program> programs,
                           const char* states) {
  std::string text;
  for (const LimitedCall& call : list_limited_calls(context, programs)) {
    text += print_call(*call.program, call.result) + "\n";
  }
  if (!holds_rows(context)) text += print_zeros(context, "J_s", context.velocities, states);
  if (context.task_rows == 0) text += print_zeros(context, "J_t", context.velocities, states);
  return text;
}

ShareWords share_words(bool of_batch) {
  return {"detail::", "detail::SupportLayout", "kSupportLayout", true, of_batch};
}

std::string print_limits(const EmissionContext& context) {
  const Syntax syntax = make_syntax(context);
  const std::string none = syntax.literal(1e30);
  return wrap_line(fmt::format("inline constexpr TorqueLimits kTorqueLimits = {{{}}};",
                               print_torque_limits(*context.limits, syntax, none, "{}")),
                   0);
}

std::string print_layout(const EmissionContext& context) {
  return wrap_line(fmt::format("inline constexpr detail::SupportLayout kSupportLayout = {{{}}};",
                               print_support_layout(*context.limits, make_syntax(context))),
                   0);
}

}  // namespace

std::string print_limited(const EmissionContext& context, std::span<const Program> programs) {
  const Program& supported = find_supported(programs);
  auto holes = c::list_limit_holes(context);
  holes["layout"] = print_layout(context);
  holes["notes"] = comment("///", describe_cones(*context.limits));
  holes["limits"] = print_limits(context);
  holes["cost"] = comment("///", describe_limited_cost(context, programs));
  holes["signature"] =
      wrap_line(print_signature(context, supported, "", "LimitedTorque& limited"), 0);
  holes["supported"] = print_supported(context, supported, "");
  holes["matrices"] = print_matrices(context, programs, "");
  add_share_holes(context, supported, share_words(false), holes);
  return fill_holes(templates::kLimited, holes);
}

std::string print_batch_limited(const EmissionContext& context, std::span<const Program> batch) {
  const Program& supported = find_supported(batch);
  auto holes = c::list_limit_holes(context);
  holes["states"] = std::to_string(context.batch);
  holes["cost"] = comment("///", describe_batch_limited_cost(context, batch));
  holes["signature"] = wrap_line(
      print_signature(context, supported, "[kStates]", "LimitedTorque (&limited)[kStates]"), 0);
  holes["supported"] = print_supported(context, supported, "[kStates]");
  holes["matrices"] = print_matrices(context, batch, "[kStates]");
  add_share_holes(context, supported, share_words(true), holes);
  return fill_holes(templates::kBatchLimited, holes);
}

}  // namespace treeline::cpp
