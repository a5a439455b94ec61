#include "cli/read_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "description/check_scene.hpp"
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

/// The function of that name among those that the scene permits.
void keep_functions(const std::vector<std::string>& names, Scene& scene, Diagnostics& diagnostics) {
  std::vector<Function> functions(kAllFunctions.begin(), kAllFunctions.end());
  functions.insert(functions.end(), kObjectFunctions.begin(), kObjectFunctions.end());
  functions.insert(functions.end(), kPostureFunctions.begin(), kPostureFunctions.end());
  functions.insert(functions.end(), kDerivativeFunctions.begin(), kDerivativeFunctions.end());
  std::vector<std::string> known;
  for (const Function function : functions) {
    known.emplace_back(function_name(function));
  }
  std::vector<Function> kept;
  for (const std::string& name : names) {
    const auto at = std::find(known.begin(), known.end(), name);
    if (at == known.end()) {
      reject("--functions", fmt::format("`{}` is no function", name), suggest_name(name, known),
             diagnostics);
      continue;
    }
    kept.push_back(functions[static_cast<std::size_t>(at - known.begin())]);
    if (needs_objects(kept.back()) && scene.objects.empty()) {
      reject("--functions", fmt::format("`{}` needs an object", name),
             "Give the scene one, or leave the function out.", diagnostics);
    }
    if (needs_points(kept.back()) && scene.operational_points.empty()) {
      reject("--functions", fmt::format("`{}` needs an operational point", name),
             "Give the scene one, or leave the function out.", diagnostics);
    }
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  scene.functions = std::move(kept);
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
  if (!options.functions.empty()) {
    keep_functions(options.functions, scene, diagnostics);
  }
}

}  // namespace

std::optional<Inputs> read_inputs(const InputOptions& options, Diagnostics& diagnostics) {
  auto robot = read_urdf(options.urdf, diagnostics);
  if (!robot) {
    return std::nullopt;
  }
  auto scene = read_scene(options.scene, *robot, diagnostics);
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
