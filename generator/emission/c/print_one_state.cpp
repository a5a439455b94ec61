#include <fmt/format.h>

#include "emission/c/print_files.hpp"
#include "emission/descriptions.hpp"

namespace treeline::c {
namespace {

/// `for (...) { to = from; }` over the elements of an argument.
std::string print_copy(const Argument& argument, std::string_view counter, const std::string& to,
                       const std::string& from) {
  return fmt::format("    for ({} i = 0; i < {}; ++i) {{\n      {} = {};\n    }}\n", counter,
                     argument.rows * argument.cols, to, from);
}

}  // namespace

OneState print_one_state(const EmissionContext& context, const Program& program, const Rows& rows,
                         Passed passed) {
  OneState state;
  const auto pass = [&](const Argument& argument) {
    state.arrays += fmt::format("    {} {}[{}];\n", number_type(context), argument.name,
                                argument.rows * argument.cols);
    state.arguments += (state.arguments.empty() ? "" : ", ") + argument.name;
  };
  const auto row_of = [&](const Argument& argument) {
    return fmt::format(fmt::runtime(rows.element), argument.name);
  };
  for (const Argument& argument : program.arguments) {
    const bool is_read = reads(program, argument);
    if (is_read || passed == Passed::all) pass(argument);
    if (is_read)
      state.before += print_copy(argument, rows.counter, argument.name + "[i]", row_of(argument));
  }
  for (const Result& result : program.results) {
    pass(result.argument);
    state.behind += print_copy(result.argument, rows.counter, row_of(result.argument),
                               result.argument.name + "[i]");
  }
  return state;
}

}  // namespace treeline::c
