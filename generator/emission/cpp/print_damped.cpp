#include "emission/cpp/print_damped.hpp"

#include <fmt/format.h>

#include "emission/comment.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_damped.hpp"
#include "emission/fill_template.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::cpp {
namespace {

std::string print_calls(const std::vector<DampedCall>& called) {
  std::string calls;
  for (const DampedCall& call : called) {
    std::string list;
    for (const Argument& argument : call.program->arguments) list += damped_name(argument) + ", ";
    calls += fmt::format("{}{}({}{});", calls.empty() ? "" : "\n", call.program->name, list,
                         call.result);
  }
  return calls;
}

/// In the order of control_torque: q, its sines and cosines, qd, qdd_0, xdd_cmd, f_ext.
std::string print_damped_signature(const Program& inverse_dynamics) {
  std::string list;
  for (const Argument& argument : inverse_dynamics.arguments) {
    list +=
        fmt::format("const Real (&{})[{}], ", damped_name(argument), argument.rows * argument.cols);
    if (argument.name == "qdd") list += "const Real (&xdd_cmd)[kTaskRows], ";
  }
  return fmt::format(
      "inline Real damped_control_torque({}Real (&tau)[kVelocities], "
      "const Real (&heaviest)[kTaskRows] = kHeaviest) noexcept {{",
      list);
}

}  // namespace

std::string print_damped(const EmissionContext& context, std::span<const Program> programs) {
  const std::vector<DampedCall> calls = list_damped_calls(programs);
  const std::string heaviest = fmt::format("inline constexpr Real kHeaviest[kTaskRows] = {{{}}};",
                                           list_heaviest(context, make_syntax(context)));
  return fill_template(templates::kDamped,
                       {{"robot", context.robot},
                        {"name", context.name},
                        {"heaviest", wrap_line(heaviest, 0)},
                        {"cost", comment("///", describe_damped_cost(context, programs))},
                        {"signature", wrap_line(print_damped_signature(*calls.back().program), 0)},
                        {"calls", print_calls(calls)}});
}

}  // namespace treeline::cpp
