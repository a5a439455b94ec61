#include "cli/read_inputs.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "description/find_function.hpp"
#include "description/identifier.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "description/suggest_name.hpp"

namespace treeline {
namespace {

void reject(const std::string& element, std::string fault, std::string remedy,
            Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, "", 0, element, std::move(fault), std::move(remedy)});
}

/// The functions of these names, sorted and unique.
std::vector<Function> find_functions(const std::vector<std::string>& names,
                                     Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const Function function : every_function()) known.emplace_back(function_name(function));
  std::vector<Function> functions;
  for (const std::string& name : names) {
    if (const auto function = find_function(name)) {
      functions.push_back(*function);
    } else {
      reject("--functions", fmt::format("`{}` is no function", name), suggest_name(name, known),
             diagnostics);
    }
  }
  std::sort(functions.begin(), functions.end());
  functions.erase(std::unique(functions.begin(), functions.end()), functions.end());
  return functions;
}

void apply(const InputOptions& options, Scene& scene, Diagnostics& diagnostics) {
  if (!options.name.empty()) {
    scene.name = options.name;
    if (!is_identifier(scene.name)) {
      reject("--name", fmt::format("`{}` cannot be a name in C++", scene.name),
             fmt::format("`{}` can.", identifier_from(scene.name)), diagnostics);
    }
  }
  if (!options.real.empty()) {
    scene.real = options.real == "float" ? Real::float32 : Real::float64;
  }
}

}  // namespace

void add_input_options(CLI::App& command, InputOptions& options) {
  command.add_option("urdf", options.urdf, "Robot, URDF")->required();
  command.add_option("scene", options.scene, "What to generate for it, YAML")->required();
  command.add_option("--real", options.real, "Number type, instead of the scene's")
      ->check(CLI::IsMember({"float", "double"}));
  command
      .add_option("--functions", options.functions,
                  "Functions, separated by commas, instead of the scene's")
      ->delimiter(',');
}

std::optional<Inputs> read_inputs(const InputOptions& options, Diagnostics& diagnostics) {
  auto robot = read_urdf(options.urdf, diagnostics);
  if (!robot) {
    return std::nullopt;
  }
  const std::vector<Function> functions = find_functions(options.functions, diagnostics);
  auto scene = read_scene(options.scene, *robot, diagnostics, functions);
  if (!scene) {
    return std::nullopt;
  }
  apply(options, *scene, diagnostics);
  if (diagnostics.has_errors()) {
    return std::nullopt;
  }
  return Inputs{std::move(*robot), std::move(*scene)};
}

void print_diagnostics(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    fmt::print(stderr, "{}\n", to_string(diagnostic));
  }
}

}  // namespace treeline
