#include "emission/c/print_damped.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <stdexcept>

#include "emission/c/print_runtime.hpp"
#include "emission/c/print_source.hpp"
#include "emission/c/syntax.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_damped.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_damped_steps.hpp"
#include "emission/print_target.hpp"
#include "emission/wrap_line.hpp"

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

/// What chooses the target's instruction for a square root: the lines of preprocessor in the
/// header of the runtime, but those for the other number type.
std::string lift_instructions(const EmissionContext& context) {
  const std::string own =
      fmt::format("TREELINE_ROOT_OF_{}", context.single_precision ? "FLOAT" : "DOUBLE");
  const std::string_view header = cpp::templates::kSquareRoot;
  const std::size_t begin = header.find("#if defined(TREELINE_PORTABLE_SQUARE_ROOT)");
  const std::size_t end = header.find("\nnamespace ", begin);
  if (begin == header.npos || end == header.npos) {
    throw std::logic_error("square_root.hpp: where are its instructions?");
  }
  std::istringstream lines{std::string(header.substr(begin, end - begin))};
  std::string lifted;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(own);
    if (line.starts_with("#define") && at == line.npos) continue;
    if (at != line.npos) {
      line.replace(at, own.size(), fmt::format("TREELINE_{}_ROOT", name_in_capitals(context)));
    }
    lifted += line + "\n";
  }
  return lifted;
}

/// The end of the function that takes a root: by the instruction where there is one.
std::string print_root(const EmissionContext& context) {
  const std::string portable =
      fmt::format("return {}_portable_square_root(positive);\n", context.name);
  return fmt::format(
      "#if defined(TREELINE_{0}_ROOT)\n  {1} root;\n  TREELINE_{0}_ROOT(root, positive);\n"
      "  return root;\n#else\n  {2}#endif\n",
      name_in_capitals(context), number_type(context), portable);
}

}  // namespace

std::string print_square_root(const EmissionContext& context) {
  const bool single = context.single_precision;
  return fill_template(templates::kSquareRoot, {{"name", context.name},
                                                {"real", number_type(context)},
                                                {"bits", single ? "uint32_t" : "uint64_t"},
                                                {"fraction", single ? "23" : "52"},
                                                {"turns", single ? "24" : "53"},
                                                {"quiet", single ? "22" : "51"},
                                                {"bias", single ? "127" : "1023"},
                                                {"sign", single ? "31" : "63"},
                                                {"infinity", single ? "255" : "2047"},
                                                {"raised", single ? "24" : "54"},
                                                {"zero", number_literal(context, "0.0")},
                                                {"instructions", lift_instructions(context)},
                                                {"root", print_root(context)}});
}

namespace {

std::string print_damped_solve(const EmissionContext& context) {
  return fill_template(templates::kDampedSolve, {{"name", context.name},
                                                 {"rows", std::to_string(context.task_rows)},
                                                 {"steps", print_damped_steps(context)}});
}

}  // namespace

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

std::vector<GeneratedFile> print_damped(const EmissionContext& context,
                                        std::span<const Program> programs) {
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

std::vector<GeneratedFile> print_damped_runtime(const EmissionContext& context) {
  return {{"damped_solve.h", print_damped_solve(context)}};
}

}  // namespace treeline::c
