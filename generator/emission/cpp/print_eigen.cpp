#include "emission/cpp/print_eigen.hpp"

#include <fmt/format.h>

#include "emission/cpp/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::cpp {
namespace {

std::string eigen_type(const Argument& argument) {
  return argument.cols == 1 ? fmt::format("Vector<{}>", argument.rows)
                            : fmt::format("Matrix<{}, {}>", argument.rows, argument.cols);
}

std::string print_wrapper(const EmissionContext& context, const Program& program) {
  std::string parameters;
  std::string arguments;
  const auto append = [&](const Argument& argument, const char* qualifier, const char* access) {
    const char* comma = parameters.empty() ? "" : ", ";
    parameters += fmt::format("{}{}{}& {}", comma, qualifier, eigen_type(argument), argument.name);
    arguments +=
        fmt::format("{}{}<{}>({})", comma, access, argument.rows * argument.cols, argument.name);
  };
  for (const Argument& argument : program.arguments) {
    append(argument, "const ", "input");
  }
  for (const Result& result : program.results) {
    append(result.argument, "", "output");
  }
  const std::string head = fmt::format("inline void {}({}) noexcept {{", program.name, parameters);
  const std::string call = fmt::format("{}::{}({});", context.name, program.name, arguments);
  return fill_template(templates::kWrapper,
                       {{"head", wrap_line(head, 0)}, {"call", wrap_line(call, 2)}});
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
