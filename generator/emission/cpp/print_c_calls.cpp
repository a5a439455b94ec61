#include "emission/cpp/print_c_calls.hpp"

#include <fmt/format.h>

#include "emission/c/hides_header.hpp"
#include "emission/c/print_contract.hpp"
#include "emission/c/print_damped.hpp"
#include "emission/c/print_joints.hpp"
#include "emission/c/print_source.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_damped.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_target.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::cpp {
namespace {

/// `arm::calls::array_at<6>(q)`
std::string pass(const EmissionContext& context, const std::string& name, int size) {
  return fmt::format("{}::calls::array_at<{}>({})", context.name, size, name);
}

std::string pass(const EmissionContext& context, const Argument& argument) {
  return pass(context, argument.name, argument.rows * argument.cols);
}

/// A function with that head that calls the one of that name with these arguments.
std::string print_passed_call(const EmissionContext& context, const std::string& head,
                              const std::string& name, const std::string& arguments,
                              const char* keyword = "") {
  const std::string call = fmt::format("{}{}::{}({});", keyword, context.name, name, arguments);
  return print_section(context) + wrap_line(head + " {", 0) + wrap_line(call, 2) + "}\n";
}

std::string pass_function(const EmissionContext& context, const Program& program) {
  std::string list;
  for (const Argument& argument : program.arguments) {
    list += (list.empty() ? "" : ", ") + pass(context, argument);
  }
  for (const Result& result : program.results) {
    list += (list.empty() ? "" : ", ") + pass(context, result.argument);
  }
  return print_passed_call(context, c::print_signature(context, program), program.name, list);
}

std::string pass_damped_function(const EmissionContext& context,
                                 std::span<const Program> programs) {
  std::string list;
  for (const Argument& argument :
       list_damped_arguments(list_damped_calls(programs), context.task_rows)) {
    list += pass(context, argument) + ", ";
  }
  list += pass(context, "tau", context.velocities) + ", ";
  list += pass(context, "heaviest", context.task_rows);
  return print_passed_call(context, c::print_damped_signature(context, programs),
                           "damped_control_torque", list, "return ");
}

}  // namespace

bool has_c_calls(const EmissionContext& context) {
  return context.language == Language::cpp && !context.misra && !c::hides_header(context.name);
}

std::vector<GeneratedFile> print_c_calls(const EmissionContext& context,
                                         std::span<const Program> programs) {
  if (!has_c_calls(context)) return {};
  const bool damped = !context.effective_mass_limits.empty();
  std::string definitions;
  for (const Program& program : programs) {
    definitions += (definitions.empty() ? "" : "\n") + pass_function(context, program);
  }
  if (damped) definitions += "\n" + pass_damped_function(context, programs);
  const std::string includes =
      damped ? fmt::format("#include \"{0}_damped.h\"\n#include \"{0}_damped.hpp\"", context.name)
             : fmt::format("#include \"{}.h\"", context.name);
  std::vector<GeneratedFile> files = {
      {context.name + ".h", c::print_contract(context, programs)},
      {context.name + "_joints.h", c::print_joints(context)},
      {"c_calls.cpp", fill_template(templates::kCCalls, {{"name", context.name},
                                                         {"includes", includes},
                                                         {"section", print_section_macro(context)},
                                                         {"definitions", definitions}})}};
  if (damped) files.push_back(c::print_damped_header(context, programs));
  return files;
}

}  // namespace treeline::cpp
