#include <fmt/format.h>

#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/list_source_holes.hpp"
#include "emission/misra/templates.hpp"
#include "emission/print_body.hpp"
#include "emission/print_files.hpp"
#include "emission/print_parts.hpp"
#include "program/ending.hpp"

namespace treeline::cpp {
namespace {

std::string parameter(const Argument& argument, const char* qualifier, const std::string& name) {
  return fmt::format("{}Real (&{})[{}]", qualifier, name, argument.rows * argument.cols);
}

/// The definition's head: restrict-qualified, and without names for arguments that straight lines
/// do not read. `restrict` stands before the names.
std::string print_head(const Program& program, const std::string& restrict) {
  const std::string list =
      join_arguments(program, [&](const Argument& argument, const char* qualifier) {
        const bool named = *qualifier == '\0' || program.loops || reads(program, argument);
        return parameter(argument, qualifier,
                         named ? restrict + argument.name : "/*" + argument.name + "*/");
      });
  return fmt::format("void {}({}) noexcept", program.name, list);
}

std::string print_includes(const EmissionContext& context, const Program& program) {
  std::string includes = uses_lanes(program) ? "#include \"lanes.hpp\"\n" : "";
  includes += print_ending_include(context, program);
  includes += uses_trigonometry(program) ? "#include \"sin_cos.hpp\"\n" : "";
  if (!includes.empty()) {
    includes.pop_back();
  }
  return includes;
}

std::string print_lanes_type(const Program& program) {
  return uses_lanes(program) ? "template <int count>\nusing Lanes = detail::Pack<Real, count>;\n"
                             : "";
}

/// The type of what the parts of a function share: each has its own name, for builds that join
/// sources.
std::string name_of_values(const Program& program) {
  return in_pascal_case(program.name) + "Values";
}

/// The head of a function that computes a part.
std::string print_part_head(const Program& program, const BodyPart& part) {
  const std::string values =
      fmt::format("{}{}& values", part.writes_values ? "" : "const ", name_of_values(program));
  const std::string list =
      list_arguments(program, part, values, [](const Argument& argument, const char* qualifier) {
        return parameter(argument, qualifier, argument.name);
      });
  return wrap_line(fmt::format("void {}({}) noexcept {{", part.name, list), 0);
}

std::string print_part_call(const Program& program, const BodyPart& part) {
  const std::string list = list_arguments(
      program, part, "values", [](const Argument& argument, const char*) { return argument.name; });
  return wrap_line(fmt::format("{}({});", part.name, list), 2);
}

std::string print_parts_of(const Program& program, const PartedBody& body) {
  if (body.parts.empty()) return {};
  std::string text = "namespace {\n\n";
  if (!body.values.empty()) {
    text += fmt::format("/// What one part computes and others read.\nstruct {} {{\n",
                        name_of_values(program));
    for (const std::string& value : body.values) text += fmt::format("  Real {};\n", value);
    text += "};\n\n";
  }
  for (const BodyPart& part : body.parts) {
    text += print_part_head(program, part) + part.statements;
    for (const std::size_t called : part.calls) {
      text += print_part_call(program, body.parts[called]);
    }
    text += "}\n\n";
  }
  return text + "}  // namespace\n\n";
}

/// Source of a function for `profile: misra`.
std::string print_safe_source(const EmissionContext& context, const Program& program) {
  std::set<std::string> taken = find_taken(context, program);
  taken.insert({"values", name_of_values(program)});
  const PartedBody body = print_parts(program, make_syntax(context), taken, "values.");
  std::string statements =
      body.values.empty() ? "" : fmt::format("  {} values;\n", name_of_values(program));
  statements += body.statements;
  for (const std::size_t called : body.calls) {
    statements += print_part_call(program, body.parts[called]);
  }
  return fill_template(misra::templates::kFunction,
                       {{"head", describe_source(program)},
                        {"cost", describe_cost(program)},
                        {"name", context.name},
                        {"includes", print_includes(context, program)},
                        {"parts", print_parts_of(program, body)},
                        {"signature", wrap_line(print_head(program, "") + " {", 0)},
                        {"body", statements}});
}

}  // namespace

std::string print_declaration(const Program& program) {
  const std::string list =
      join_arguments(program, [](const Argument& argument, const char* qualifier) {
        return parameter(argument, qualifier, argument.name);
      });
  return wrap_line(fmt::format("void {}({}) noexcept;", program.name, list), 0);
}

std::string print_source(const EmissionContext& context, const Program& program) {
  if (!program.loops && context.misra) return print_safe_source(context, program);
  const char* const restrict = program.loops ? "" : "TREELINE_RESTRICT ";
  auto holes = list_source_holes(context, program, print_head(program, restrict));
  if (program.loops) {
    holes["body"] = print_loop_body(context, program);
    return fill_template(templates::kLoopFunction, holes);
  }
  const std::string lines =
      print_body(printed_lines(program), make_syntax(context), find_taken(context, program));
  holes.insert({{"includes", print_includes(context, program)},
                {"lanes", print_lanes_type(program)},
                {"body", add_ending(context, program, lines)}});
  return fill_template(templates::kFunction, holes);
}

std::set<std::string> find_taken(const EmissionContext& context, const Program& program) {
  return find_taken_names(program, {"Real", "Lanes", "detail", "kCoordinates", "kVelocities",
                                    "kTaskRows", context.name});
}

}  // namespace treeline::cpp
