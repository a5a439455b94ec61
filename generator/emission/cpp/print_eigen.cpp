#include <fmt/format.h>

#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/emitted_text.hpp"

namespace treeline::cpp {
namespace {

/// The size of an argument, as template arguments.
std::string print_size(const Argument& argument) {
  return argument.cols == 1 ? fmt::format("<{}>", argument.rows)
                            : fmt::format("<{}, {}>", argument.rows, argument.cols);
}

/// One function for every kind of Eigen object: `T0`, `T1` and so on are the types of its
/// arguments.
std::string print_wrapper(const EmissionContext& context, const Program& program) {
  std::string types;
  std::string parameters;
  std::string arguments;
  int count = 0;
  const auto append = [&](const Argument& argument, const char* access) {
    const char* comma = count == 0 ? "" : ", ";
    types += fmt::format("{}class T{}", comma, count);
    parameters += fmt::format("{}const Eigen::MatrixBase<T{}>& {}", comma, count, argument.name);
    arguments += fmt::format("{}detail::{}{}({}).array()", comma, access, print_size(argument),
                             argument.name);
    ++count;
  };
  for (const Argument& argument : program.arguments) append(argument, "input");
  for (const Result& result : program.results) append(result.argument, "output");
  const std::string head = fmt::format("void {}({}) {{", program.name, parameters);
  const std::string call = fmt::format("{}::{}({});", context.name, program.name, arguments);
  return fill_template(templates::kWrapper, {{"types", wrap_line("template <" + types + ">", 0)},
                                             {"head", wrap_line(head, 0)},
                                             {"call", wrap_line(call, 2)}});
}

}  // namespace

std::string print_eigen(const EmissionContext& context, std::span<const Program> programs) {
  std::string wrappers;
  for (const Program& program : programs) {
    wrappers += wrappers.empty() ? "" : "\n";
    wrappers += print_wrapper(context, program);
  }
  return fill_template(templates::kEigen,
                       {{"robot", context.robot}, {"name", context.name}, {"wrappers", wrappers}});
}

}  // namespace treeline::cpp
