#include "emission/c/print_damped.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <stdexcept>

#include "core/symmetric_eigen.hpp"
#include "emission/c/print_runtime.hpp"
#include "emission/c/print_source.hpp"
#include "emission/c/syntax.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_damped.hpp"
#include "emission/fill_template.hpp"
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

std::string print_damped_head(const EmissionContext& context,
                              const std::vector<Argument>& arguments) {
  const char* const real = context.single_precision ? "float" : "double";
  std::string list;
  for (const Argument& argument : arguments) {
    list += print_array(context, "const ", argument.name, argument.rows * argument.cols) + ", ";
  }
  return fmt::format("{} {}_damped_control_torque({}{}, {})", real, context.name, list,
                     print_array(context, "", "tau", context.velocities),
                     print_array(context, "const ", "heaviest", context.task_rows));
}

/// What chooses the target's instruction for a square root: the lines of preprocessor in the
/// header of the runtime, but those for the other number type.
std::string lift_instructions(const EmissionContext& context) {
  if (context.misra) return {};
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
  if (context.misra) return "  " + portable;
  return fmt::format(
      "#if defined(TREELINE_{0}_ROOT)\n  {1} root;\n  TREELINE_{0}_ROOT(root, positive);\n"
      "  return root;\n#else\n  {2}#endif\n",
      name_in_capitals(context), context.single_precision ? "float" : "double", portable);
}

}  // namespace

std::string print_square_root(const EmissionContext& context) {
  const bool single = context.single_precision;
  return fill_template(
      templates::kSquareRoot,
      {{"name", context.name},
       {"real", single ? "float" : "double"},
       {"bits", single ? "uint32_t" : "uint64_t"},
       {"fraction", single ? "23" : "52"},
       {"turns", single ? "24" : "53"},
       {"quiet", single ? "22" : "51"},
       {"bias", single ? "127" : "1023"},
       {"sign", single ? "31" : "63"},
       {"infinity", single ? "255" : "2047"},
       {"raised", single ? "24" : "54"},
       {"zero", number_literal(context, "0.0")},
       {"include", context.misra ? "#include <stdint.h>" : "#include \"sin_cos.h\""},
       {"number", context.misra ? print_number(context) + "\n" : std::string()},
       {"instructions", lift_instructions(context)},
       {"root", print_root(context)}});
}

namespace {

std::string print_damped_solve(const EmissionContext& context) {
  const bool single = context.single_precision;
  const int rows = context.task_rows;
  const int sweeps = single ? core::ql_sweeps<float>(rows) : core::ql_sweeps<double>(rows);
  return fill_template(templates::kDampedSolve, {{"name", context.name},
                                                 {"real", single ? "float" : "double"},
                                                 {"rows", std::to_string(rows)},
                                                 {"sweeps", std::to_string(sweeps)},
                                                 {"resolution", single ? "0x1p-17F" : "0x1p-46"},
                                                 {"negligible", single ? "0x1p-21F" : "0x1p-50"},
                                                 {"lost", single ? "1e-30F" : "1e-280"},
                                                 {"half", number_literal(context, "0.5")},
                                                 {"zero", number_literal(context, "0.0")},
                                                 {"one", number_literal(context, "1.0")},
                                                 {"two", number_literal(context, "2.0")}});
}

}  // namespace

std::vector<GeneratedFile> print_damped(const EmissionContext& context,
                                        std::span<const Program> programs) {
  const std::vector<DampedCall> calls = list_damped_calls(programs);
  const std::string real = context.single_precision ? "float" : "double";
  const std::string head =
      print_damped_head(context, list_damped_arguments(calls, context.task_rows));
  const std::string heaviest =
      fmt::format("static const {} {}_heaviest[{}] = {{{}}};", real, context.name,
                  context.task_rows, list_heaviest(context, make_syntax(context)));
  return {
      {context.name + "_damped.h",
       fill_template(templates::kDamped,
                     {{"robot", context.robot},
                      {"name", context.name},
                      {"heaviest", wrap_line(heaviest, 0)},
                      {"cost", comment("///", describe_damped_cost(context, programs))},
                      {"signature", wrap_line(head + ";", 0)}})},
      {"damped_control_torque.c",
       fill_template(templates::kDampedSource, {{"name", context.name},
                                                {"NAME", name_in_capitals(context)},
                                                {"real", real},
                                                {"signature", wrap_line(head + " {", 0)},
                                                {"calls", print_damped_calls(context, calls)}})}};
}

std::vector<GeneratedFile> print_damped_runtime(const EmissionContext& context) {
  return {{"damped_solve.h", print_damped_solve(context)}};
}

}  // namespace treeline::c
