#include "emission/cpp/print_c_calls.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "emission/c/hides_header.hpp"
#include "emission/c/print_batch.hpp"
#include "emission/c/print_contract.hpp"
#include "emission/c/print_damped.hpp"
#include "emission/c/print_joints.hpp"
#include "emission/c/print_limited.hpp"
#include "emission/c/print_source.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_damped.hpp"
#include "emission/describe_limited.hpp"
#include "emission/fill_template.hpp"
#include "emission/join_arguments.hpp"
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
  const std::string list = join_arguments(
      program, [&](const Argument& argument, const char*) { return pass(context, argument); });
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

std::string pass_batch_function(const EmissionContext& context, const Program& program) {
  const std::string list = join_arguments(program, [&](const Argument& argument, const char*) {
    return fmt::format("{}::rows_at<{}>({})", context.name, argument.rows * argument.cols,
                       argument.name);
  });
  return print_passed_call(context, c::print_batch_signature(context, program),
                           "batch::" + program.name, list);
}

std::string pass_limited_function(const EmissionContext& context,
                                  std::span<const Program> programs) {
  std::string list;
  for (const Argument& argument : find_supported(programs).arguments) {
    list += pass(context, argument) + ", ";
  }
  list += pass(context, "tau", context.velocities) + ", ";
  if (holds_rows(context)) {
    list += pass(context, "f", static_cast<int>(context.limits->force_weights.size())) + ", ";
  }
  const std::string call =
      fmt::format("{}::limited_control_torque({}own, own_limits);", context.name, list);
  return fill_template(
      templates::kCCallsLimited,
      {{"name", context.name},
       {"limits", c::print_default_limits(context)},
       {"signature", print_section(context) +
                         wrap_line(c::print_limited_signature(context, programs) + " {", 0)},
       {"call", wrap_line(call, 2)}});
}

/// Parts of c_calls.cpp, and the headers that declare its functions.
struct Parts {
  std::string includes, helpers;
  std::vector<std::string> definitions;
  std::vector<GeneratedFile> headers;
};

/// Behind other lines: the header of C and that of C++.
void include_both(const EmissionContext& context, const char* what, Parts& parts) {
  parts.includes +=
      fmt::format("\n#include \"{0}_{1}.h\"\n#include \"{0}_{1}.hpp\"", context.name, what);
}

/// The functions of one state.
Parts pass_functions(const EmissionContext& context, std::span<const Program> programs) {
  Parts parts;
  parts.includes = fmt::format("#include \"{}.h\"", context.name);
  parts.headers = {{context.name + ".h", c::print_contract(context, programs)},
                   {context.name + "_joints.h", c::print_joints(context)}};
  for (const Program& program : programs) {
    parts.definitions.push_back(pass_function(context, program));
  }
  if (context.effective_mass_limits.empty()) return parts;
  parts.includes =
      fmt::format("#include \"{0}_damped.h\"\n#include \"{0}_damped.hpp\"", context.name);
  parts.definitions.push_back(pass_damped_function(context, programs));
  parts.headers.push_back(c::print_damped_header(context, programs));
  return parts;
}

void pass_batch(const EmissionContext& context, std::span<const Program> batch, Parts& parts) {
  include_both(context, "batch", parts);
  parts.helpers += fill_template(templates::kCCallsBatch, {{"name", context.name}}) + "\n";
  for (const Program& program : batch) {
    parts.definitions.push_back(pass_batch_function(context, program));
  }
  parts.headers.push_back(c::print_batch_header(context, batch));
}

void pass_limited(const EmissionContext& context, std::span<const Program> programs, Parts& parts) {
  include_both(context, "limited", parts);
  const auto holes = c::list_limit_holes(context);
  parts.helpers += c::fill_limits(templates::kCCallsLimits, holes) + "\n";
  parts.definitions.push_back(pass_limited_function(context, programs));
  parts.headers.push_back(c::print_limited_header(context, programs));
}

}  // namespace

bool has_c_calls(const EmissionContext& context) {
  return context.language == Language::cpp && !context.misra && !c::hides_header(context.name);
}

std::vector<GeneratedFile> print_c_calls(const Contents& contents) {
  const EmissionContext& context = contents.context;
  Parts parts = pass_functions(context, contents.programs);
  if (!contents.batch.empty()) pass_batch(context, contents.batch, parts);
  if (context.limits) pass_limited(context, contents.programs, parts);
  std::vector<GeneratedFile> files = std::move(parts.headers);
  files.push_back(
      {"c_calls.cpp",
       fill_template(templates::kCCalls,
                     {{"name", context.name},
                      {"includes", parts.includes},
                      {"section", print_section_macro(context)},
                      {"helpers", parts.helpers},
                      {"definitions", fmt::format("{}", fmt::join(parts.definitions, "\n"))}})});
  return files;
}

}  // namespace treeline::cpp
