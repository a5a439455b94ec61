#include "emission/c/print_source.hpp"

#include <fmt/format.h>

#include <cctype>

#include "emission/c/syntax.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/describe_program.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_body.hpp"
#include "emission/print_target.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::c {
namespace {

std::string parameter(const EmissionContext& context, const Argument& argument,
                      const char* qualifier) {
  return fmt::format("{}{} {}[TREELINE_{}_ARRAY({})]", qualifier,
                     context.single_precision ? "float" : "double", argument.name,
                     name_in_capitals(context), argument.rows * argument.cols);
}

std::string print_includes(const Program& program) {
  std::string includes = uses_lanes(program) ? "#include \"lanes.h\"\n" : "";
  includes += uses_trigonometry(program) ? "#include \"sin_cos.h\"\n" : "";
  return includes;
}

/// C99 has no parameters without names.
std::string print_unread(const Program& program) {
  std::string statements;
  for (const Argument& argument : program.arguments) {
    if (!reads(program, argument)) statements += fmt::format("  (void){};\n", argument.name);
  }
  return statements;
}

}  // namespace

std::string print_signature(const EmissionContext& context, const Program& program) {
  std::string list;
  for (const Argument& argument : program.arguments) {
    list += (list.empty() ? "" : ", ") + parameter(context, argument, "const ");
  }
  for (const Result& result : program.results) {
    list += (list.empty() ? "" : ", ") + parameter(context, result.argument, "");
  }
  return fmt::format("void {}_{}({})", context.name, program.name, list);
}

std::string print_source(const EmissionContext& context, const Program& program) {
  const std::set<std::string> taken =
      find_taken_names(program, {context.name, fmt::format("{}_{}", context.name, program.name),
                                 fmt::format("{}_sin_cos", context.name)});
  return fill_template(templates::kFunction,
                       {{"head", describe_source(program)},
                        {"cost", describe_cost(program)},
                        {"name", context.name},
                        {"includes", print_includes(program)},
                        {"section", print_section_macro(context)},
                        {"signature", print_section(context) +
                                          wrap_line(print_signature(context, program) + " {", 0)},
                        {"unread", print_unread(program)},
                        {"body", print_body(program, make_syntax(context), taken)}});
}

}  // namespace treeline::c
