#include <fmt/format.h>

#include "emission/c/print_files.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_target.hpp"

namespace treeline::c {
namespace {

std::string print_damped_calls(const EmissionContext& context,
                               const std::vector<DampedCall>& called) {
  std::string calls;
  for (const DampedCall& call : called) {
    std::string list;
    for (const Argument& argument : call.program->arguments) list += damped_name(argument) + ", ";
    calls += fmt::format("{}_{}({}{});\n", context.name, call.program->name, list, call.result);
  }
  return calls;
}

std::string print_damped_signature(const EmissionContext& context,
                                   std::span<const Program> programs) {
  const char* const real = number_type(context);
  std::string list;
  for (const Argument& argument :
       list_damped_arguments(list_damped_calls(programs), context.task_rows)) {
    list += print_array(context, "const ", argument.name, argument.rows * argument.cols) + ", ";
  }
  return fmt::format("{} {}_damped_control_torque({}{}, {})", real, context.name, list,
                     print_array(context, "", "tau", context.velocities),
                     print_array(context, "const ", "heaviest", context.task_rows));
}

GeneratedFile print_damped_header(const EmissionContext& context,
                                  std::span<const Program> programs) {
  const std::string limits =
      fmt::format("static const {} {}_heaviest[{}] = {{{}}};", number_type(context), context.name,
                  context.task_rows, list_effective_mass_limits(context, make_syntax(context)));
  return {context.name + "_damped.h",
          fill_template(
              templates::kDamped,
              {{"robot", context.robot},
               {"name", context.name},
               {"heaviest", wrap_line(limits, 0)},
               {"cost", comment("///", describe_damped_cost(context, programs))},
               {"signature", wrap_line(print_damped_signature(context, programs) + ";", 0)}})};
}

}  // namespace

std::vector<GeneratedFile> print_damped(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const auto& programs = contents.programs;
  return {print_damped_header(context, programs),
          {"damped_control_torque.c",
           fill_template(
               templates::kDampedSource,
               {{"name", context.name},
                {"NAME", name_in_capitals(context)},
                {"real", number_type(context)},
                {"section", print_section_macro(context)},
                {"signature", print_section(context) +
                                  wrap_line(print_damped_signature(context, programs) + " {", 0)},
                {"calls", print_damped_calls(context, list_damped_calls(programs))}})}};
}

}  // namespace treeline::c
