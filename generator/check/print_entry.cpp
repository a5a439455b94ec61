#include "check/print_entry.hpp"

#include <fmt/format.h>

#include "check/templates.hpp"
#include "emission/fill_template.hpp"

namespace treeline {
namespace {

std::string print_arguments(const GeneratedFunction& generated) {
  const Program& program = generated.program;
  const bool batch = generated.batch > 0;
  std::string text;
  const auto append = [&](const char* direction, const Argument& argument, const char* array,
                          std::size_t i) {
    text += fmt::format("{}{}{}<{}>({}[{}]){}", text.empty() ? "" : ", ", batch ? "batch_" : "",
                        direction, argument.rows * argument.cols, array, i, batch ? ".all()" : "");
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
  bool has_batch = false;
  for (const GeneratedFunction& generated : functions) {
    has_batch = has_batch || generated.batch > 0;
    text +=
        fill_template(check_templates::kFunction,
                      {{"name", generated.batch > 0 ? name + "::batch" : name},
                       {"entry", source_stem(generated)},
                       {"function", generated.program.name},
                       {"arguments", print_arguments(generated)},
                       {"after", generated.batch > 0 ? "\n  lane = (lane + 1) % kStates;" : ""}});
  }
  const std::string batch =
      has_batch ? fill_template(check_templates::kBatch, {{"name", name}}) : "";
  return fill_template(check_templates::kEntry,
                       {{"name", name}, {"batch", batch}, {"functions", text}});
}

std::string entry_symbol(const std::string& function) {
  return "treeline_check_" + function;
}

}  // namespace treeline
