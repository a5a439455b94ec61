#include <fmt/format.h>

#include <cctype>

#include "emission/c/print_files.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/list_source_holes.hpp"
#include "emission/print_body.hpp"
#include "emission/print_files.hpp"
#include "emission/print_parts.hpp"
#include "program/ending.hpp"

namespace treeline::c {
namespace {

std::string parameter(const EmissionContext& context, const Argument& argument,
                      const char* qualifier) {
  return print_array(context, qualifier, argument.name, argument.rows * argument.cols);
}

std::string print_includes(const EmissionContext& context, const Program& program) {
  std::string includes = uses_lanes(program) ? "#include \"lanes.h\"\n" : "";
  includes += print_ending_include(context, program);
  includes += uses_trigonometry(program) ? "#include \"sin_cos.h\"\n" : "";
  return includes;
}

/// The head of a function that computes a part.
std::string print_part_head(const EmissionContext& context, const Program& program,
                            const BodyPart& part) {
  const std::string values = fmt::format(
      "{}{}_{}_values *values", part.writes_values ? "" : "const ", context.name, program.name);
  const std::string list =
      list_arguments(program, part, values, [&](const Argument& argument, const char* qualifier) {
        return parameter(context, argument, qualifier);
      });
  return wrap_line(fmt::format("static void {}_{}({}) {{", context.name, part.name, list), 0);
}

/// `values` is how the caller passes what parts share.
std::string print_part_call(const EmissionContext& context, const Program& program,
                            const BodyPart& part, const char* values) {
  const std::string list = list_arguments(
      program, part, values, [](const Argument& argument, const char*) { return argument.name; });
  return wrap_line(fmt::format("{}_{}({});", context.name, part.name, list), 2);
}

struct Body {
  std::string parts;       ///< what stands before the function
  std::string statements;  ///< its own
};

Body print_body_of(const EmissionContext& context, const Program& program,
                   std::set<std::string> taken) {
  const Syntax syntax = make_syntax(context);
  if (!context.misra) {
    const std::string lines = print_body(printed_lines(program), syntax, taken);
    return {"", add_ending(context, program, lines)};
  }
  taken.insert("values");
  const PartedBody body = print_parts(program, syntax, taken, "values->");
  if (body.parts.empty()) return {"", body.statements};
  Body text;
  if (!body.values.empty()) {
    text.parts += "/* What one part computes and others read. */\ntypedef struct {\n";
    for (const std::string& value : body.values) {
      text.parts += fmt::format("  {} {};\n", syntax.number, value);
    }
    text.parts += fmt::format("}} {}_{}_values;\n\n", context.name, program.name);
    text.statements += fmt::format("  {}_{}_values values;\n", context.name, program.name);
  }
  for (const BodyPart& part : body.parts) {
    text.parts += print_part_head(context, program, part) + part.statements;
    for (const std::size_t called : part.calls) {
      text.parts += print_part_call(context, program, body.parts[called], "values");
    }
    text.parts += "}\n\n";
  }
  for (const std::size_t called : body.calls) {
    text.statements += print_part_call(context, program, body.parts[called], "&values");
  }
  return text;
}

}  // namespace

std::string print_unread(const Program& program, std::string_view suffix) {
  std::string statements;
  for (const Argument& argument : program.arguments) {
    if (!reads(program, argument)) {
      statements += fmt::format("  (void){}{};\n", argument.name, suffix);
    }
  }
  return statements;
}

std::string print_array(const EmissionContext& context, const char* qualifier,
                        const std::string& name, int size) {
  const char* const real = number_type(context);
  return context.misra ? fmt::format("{}{} {}[{}]", qualifier, real, name, size)
                       : fmt::format("{}{} {}[TREELINE_{}_ARRAY({})]", qualifier, real, name,
                                     name_in_capitals(context), size);
}

std::string print_signature(const EmissionContext& context, const Program& program) {
  const std::string list =
      join_arguments(program, [&](const Argument& argument, const char* qualifier) {
        return parameter(context, argument, qualifier);
      });
  return fmt::format("void {}_{}({})", context.name, program.name, list);
}

std::string print_declaration(const EmissionContext& context, const Program& program) {
  return wrap_line(print_signature(context, program) + ";", 0);
}

std::string print_source(const EmissionContext& context, const Program& program) {
  auto holes = list_source_holes(context, program, print_signature(context, program));
  if (program.loops) {
    holes["body"] = print_loop_body(context, program);
    return fill_template(templates::kLoopFunction, holes);
  }
  const std::set<std::string> taken =
      find_taken_names(program, {context.name, fmt::format("{}_{}", context.name, program.name),
                                 fmt::format("{}_sin_cos", context.name)});
  const Body body = print_body_of(context, program, taken);
  holes.insert({{"includes", print_includes(context, program)},
                {"parts", body.parts},
                {"unread", print_unread(program)},
                {"body", body.statements}});
  return fill_template(templates::kFunction, holes);
}

}  // namespace treeline::c
