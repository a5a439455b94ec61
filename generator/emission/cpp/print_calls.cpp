#include <fmt/format.h>

#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/emitted_text.hpp"

namespace treeline::cpp {
namespace {

int size_of(const Argument& argument) {
  return argument.rows * argument.cols;
}

std::string print_member(const Argument& argument) {
  const std::string shape =
      argument.cols == 1 ? "" : fmt::format("{} x {}, ", argument.rows, argument.cols);
  return comment("  ///", wrap_text(shape + argument.meaning, 93)) +
         fmt::format("  Real {}[{}];\n", argument.name, size_of(argument));
}

/// The structs of a function and the function that takes them.
std::string print_structs(const EmissionContext& context, const Program& program) {
  const std::string pascal = in_pascal_case(program.name);
  std::string inputs;
  std::string outputs;
  std::string arguments;
  for (const Argument& argument : program.arguments) {
    inputs += print_member(argument);
    arguments += "in." + argument.name + ", ";
  }
  for (const Result& result : program.results) {
    outputs += print_member(result.argument);
    arguments += "out." + result.argument.name + ", ";
  }
  arguments.resize(arguments.size() - 2);
  const std::string type = fmt::format("inline {}Output", pascal);
  const std::string call = fmt::format("{}(const {}Input& in) noexcept {{", program.name, pascal);
  const char* const gap = type.size() + 1 + call.size() > 100 ? "\n" : " ";
  return fill_template(
      templates::kNamedCall,
      {{"function", program.name},
       {"Function", pascal},
       {"inputs", inputs},
       {"outputs", outputs},
       {"head", type + gap + call},
       {"call", wrap_line(fmt::format("{}::{}({});", context.name, program.name, arguments), 2)}});
}

/// The function for arguments of std::array.
std::string print_array_call(const EmissionContext& context, const Program& program) {
  const std::string parameters = join_arguments(program, [](const Argument& argument,
                                                            const char* qualifier) {
    return fmt::format("{}std::array<Real, {}>& {}", qualifier, size_of(argument), argument.name);
  });
  const std::string arguments = join_arguments(program, [](const Argument& argument, const char*) {
    return fmt::format("array_at<{}>({}.data())", size_of(argument), argument.name);
  });
  const std::string head =
      wrap_line(fmt::format("inline void {}({}) noexcept {{", program.name, parameters), 0);
  return head + "\n" +
         wrap_line(fmt::format("{}::{}({});", context.name, program.name, arguments), 2) + "\n}\n";
}

}  // namespace

std::string print_calls(const EmissionContext& context, std::span<const Program> programs) {
  std::string structs;
  std::string arrays;
  for (const Program& program : programs) {
    structs += print_structs(context, program) + "\n";
    arrays += print_array_call(context, program) + "\n";
  }
  return fill_template(templates::kCalls, {{"robot", context.robot},
                                           {"name", context.name},
                                           {"NAME", name_in_capitals(context)},
                                           {"structs", structs},
                                           {"arrays", arrays}});
}

}  // namespace treeline::cpp
