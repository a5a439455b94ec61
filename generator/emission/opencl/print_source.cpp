#include <fmt/format.h>

#include "emission/c/print_files.hpp"
#include "emission/emitted_text.hpp"
#include "emission/opencl/print_files.hpp"
#include "emission/opencl/templates.hpp"

namespace treeline::opencl {
namespace {

/// A buffer for each argument, a line each.
std::string list_buffers(const EmissionContext& context, const Program& program) {
  std::string list;
  const auto append = [&](const Argument& argument, const char* qualifier) {
    list += fmt::format(",\n    __global {}{}* restrict {}_states", qualifier, number_type(context),
                        argument.name);
  };
  for (const Argument& argument : program.arguments) append(argument, "const ");
  for (const Result& result : program.results) append(result.argument, "");
  return list;
}

std::string print_kernel(const EmissionContext& context, const Program& program) {
  const c::OneState one =
      c::print_one_state(context, program, {"{}_states[(i * count) + k]", "uint"}, c::Passed::all);
  return fill_template(
      templates::kKernel,
      {{"name", context.name},
       {"function", program.name},
       {"parameters", list_buffers(context, program)},
       {"unread", c::print_unread(program, "_states")},
       {"arrays", one.arrays},
       {"before", one.before},
       {"call", wrap_line(fmt::format("{}_{}({});", context.name, program.name, one.arguments), 4)},
       {"behind", one.behind}});
}

}  // namespace

std::string print_source(const EmissionContext& context, const Program& program) {
  return c::print_source(context, program) + print_kernel(context, program);
}

}  // namespace treeline::opencl
