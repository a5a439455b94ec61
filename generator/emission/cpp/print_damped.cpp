#include <fmt/format.h>

#include "emission/comment.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"

namespace treeline::cpp {
namespace {

std::string print_damped_calls(const std::vector<DampedCall>& called) {
  std::string calls;
  for (const DampedCall& call : called) {
    std::string list;
    for (const Argument& argument : call.program->arguments) list += damped_name(argument) + ", ";
    calls += fmt::format("{}{}({}{});", calls.empty() ? "" : "\n", call.program->name, list,
                         call.result);
  }
  return calls;
}

std::string print_damped_signature(const std::vector<Argument>& arguments) {
  std::string list;
  for (const Argument& argument : arguments) {
    const std::string size = argument.name == "xdd_cmd"
                                 ? std::string("kTaskRows")
                                 : std::to_string(argument.rows * argument.cols);
    list += fmt::format("const Real (&{})[{}], ", argument.name, size);
  }
  return fmt::format(
      "inline Real damped_control_torque({}Real (&tau)[kVelocities], "
      "const Real (&heaviest)[kTaskRows] = kHeaviest) noexcept {{",
      list);
}

}  // namespace

std::string print_damped(const EmissionContext& context, std::span<const Program> programs) {
  const std::vector<DampedCall> calls = list_damped_calls(programs);
  const std::string limits = fmt::format("inline constexpr Real kHeaviest[kTaskRows] = {{{}}};",
                                         list_effective_mass_limits(context, make_syntax(context)));
  return fill_template(
      templates::kDamped,
      {{"robot", context.robot},
       {"name", context.name},
       {"heaviest", wrap_line(limits, 0)},
       {"cost", comment("///", describe_damped_cost(context, programs))},
       {"signature",
        wrap_line(print_damped_signature(list_damped_arguments(calls, context.task_rows)), 0)},
       {"calls", print_damped_calls(calls)}});
}

}  // namespace treeline::cpp
