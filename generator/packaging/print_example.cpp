#include <fmt/format.h>

#include "emission/backend.hpp"
#include "emission/emitted_text.hpp"
#include "packaging/package_kinds.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

/// A line that gives q the home position, if the function takes it.
std::string print_home(const Scene& scene, const Program& program) {
  for (const Argument& argument : program.arguments) {
    if (argument.name != "q") continue;
    const std::string home =
        scene.name + (backend_of(scene.language).has_namespaces ? "::kHome" : "_home");
    return fmt::format("for (int i = 0; i < {}; ++i) q[i] = {}[i];", argument.rows, home);
  }
  return "";
}

}  // namespace

std::string print_example(const Scene& scene, const Generation& generation,
                          const PackageFacts& facts) {
  const Program& program = generation.functions.front().program;
  const char* real = scene.real == Real::float32 ? "float" : "double";
  const std::string_view between = backend_of(scene.language).scope;
  std::string arrays;
  std::string list;
  const auto append = [&](const Argument& argument) {
    arrays += fmt::format("{} {}[{}];\n", real, argument.name, argument.rows * argument.cols);
    list += (list.empty() ? "" : ", ") + argument.name;
  };
  for (const Argument& argument : program.arguments) append(argument);
  for (const Result& result : program.results) append(result.argument);
  arrays.pop_back();
  return fill_template(
      package_templates::kArduinoExample,
      {{"call_name", program.name},
       {"header", facts.at("header")},
       {"joints_header", facts.at("joints_header")},
       {"arrays", arrays},
       {"home", print_home(scene, program)},
       {"call", wrap_line(fmt::format("{}{}{}({});", scene.name, between, program.name, list), 0)},
       {"result", program.results.front().argument.name}});
}

}  // namespace treeline
