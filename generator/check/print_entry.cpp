#include "check/print_entry.hpp"

#include <fmt/format.h>

#include "check/templates.hpp"
#include "emission/fill_template.hpp"

namespace treeline {
namespace {

std::string print_arguments(const Program& program) {
  std::string text;
  const auto append = [&](const char* direction, const Argument& argument, const char* array,
                          std::size_t i) {
    text += fmt::format("{}{}<{}>({}[{}])", text.empty() ? "" : ", ", direction,
                        argument.rows * argument.cols, array, i);
  };
  for (std::size_t i = 0; i < program.arguments.size(); ++i) {
    append("input", program.arguments[i], "in", i);
  }
  for (std::size_t i = 0; i < program.results.size(); ++i) {
    append("output", program.results[i].argument, "out", i);
  }
  return text;
}

}  // namespace

std::string print_entry(const std::string& name, const std::vector<GeneratedFunction>& functions) {
  std::string text;
  for (const GeneratedFunction& generated : functions) {
    const Program& program = generated.program;
    text += fill_template(
        check_templates::kFunction,
        {{"name", name}, {"function", program.name}, {"arguments", print_arguments(program)}});
  }
  return fill_template(check_templates::kEntry, {{"name", name}, {"functions", text}});
}

std::string entry_symbol(const std::string& function) {
  return "treeline_check_" + function;
}

}  // namespace treeline
