#include "cli/read_inputs.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "cli/find_all_meshes.hpp"
#include "description/follow_target.hpp"
#include "description/noise.hpp"
#include "description/read_number.hpp"
#include "description/scene_queries.hpp"
#include "description/scene_words.hpp"
#include "description/suggestions.hpp"
#include "emission/backend.hpp"
#include "functions/function.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/leave_out_singular.hpp"
#include "packaging/package_kinds.hpp"
#include "terminal/option_values.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

void reject(const std::string& element, std::string fault, std::string remedy,
            Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, "", 0, element, std::move(fault), std::move(remedy)});
}

/// The functions of these names, sorted and unique.
std::vector<Function> find_functions(const std::vector<std::string>& names,
                                     Diagnostics& diagnostics) {
  std::vector<Function> functions;
  for (const std::string& given : names) {
    const std::string name(trimmed(given));
    if (const auto function = find_function(name)) {
      functions.push_back(*function);
    } else {
      reject(kFunctionsOption, fmt::format("there is no function \"{}\"", name),
             suggest_function(name), diagnostics);
    }
  }
  std::sort(functions.begin(), functions.end());
  functions.erase(std::unique(functions.begin(), functions.end()), functions.end());
  return functions;
}

void apply(const InputOptions& options, const std::string& scene_text, Scene& scene,
           Diagnostics& diagnostics) {
  if (!options.name.empty()) {
    scene.name = options.name;
    if (!is_package_name(scene.name)) {
      reject("--name",
             fmt::format("`{}` cannot be a name in emitted code and in CMake", scene.name),
             fmt::format("`{}` can.", package_name_from(scene.name)), diagnostics);
    }
  }
  scene.real = value_of_word<Real>(options.real).value_or(scene.real);
  const PackageKind* const package = find_package(options.package);
  if (package != nullptr && !package->of_c.empty()) {
    adapt_to_c(*package, scene_text, scene, diagnostics);
    if (options.language == word_of(Language::cpp)) {
      reject("--language", std::string(package->of_c) + " is compiled from C", "Leave it out.",
             diagnostics);
    }
  }
  scene.language = value_of_word<Language>(options.language).value_or(scene.language);
  scene.profile = value_of_word<Profile>(options.profile).value_or(scene.profile);
  scene.optimize = value_of_word<Optimize>(options.optimize).value_or(scene.optimize);
  if (!options.target.empty()) scene.target = options.target;
  follow_target(scene);
  warn_of_target(scene, diagnostics);
}

/// Reports why a package cannot be made: of its language alone, else all that its kind refuses.
void refuse_package(const PackageKind& package, const Robot& robot, const Scene& scene,
                    Diagnostics& diagnostics) {
  const Backend& backend = backend_of(scene.language);
  if (backend.is_compiled_by_driver()) {
    reject("--package",
           fmt::format("packages are compiled, and {} is by the driver of a device", backend.name),
           "Leave it out.", diagnostics);
    return;
  }
  if (package.calls_a_function && scene.functions.empty() &&
      !(package.is_unit && scene.controller)) {
    reject("functions",
           fmt::format("--package {} calls functions, and the scene has none", package.option),
           "List those that it should have, for instance `inverse_dynamics`.", diagnostics);
  }
  if (package.refuse != nullptr) package.refuse(robot, scene, diagnostics);
}

}  // namespace

void add_input_options(CLI::App& command, InputOptions& options) {
  command.add_option("urdf", options.urdf, kRobotArgument)->required();
  command.add_option("scene", options.scene,
                     "What to generate for it, YAML; without: functions of the joints alone");
  command.add_option("--real", options.real, "Number type, instead of the scene's")
      ->check(one_of(words_of<Real>()));
  command
      .add_option("--target", options.target, "Processor the code is for, instead of the scene's")
      ->check(one_of(target_names()));
  command
      .add_option(kFunctionsOption, options.functions,
                  "Functions, separated by commas, instead of the scene's")
      ->delimiter(',')
      ->allow_extra_args(false);  // what follows is a file
  add_warnings_option(command, options.warnings);
}

void add_language_option(CLI::App& command, InputOptions& options) {
  command.add_option("--language", options.language, "Of the code, instead of the scene's")
      ->check(one_of(words_of<Language>()));
  command
      .add_option(
          "--profile", options.profile,
          "How the code is written, instead of the scene's: misra follows rules for safe code")
      ->check(one_of(words_of<Profile>()));
  command
      .add_option("--optimize", options.optimize,
                  "For speed, or for small code, instead of the scene's")
      ->check(one_of(words_of<Optimize>()));
}

std::optional<RobotAndScene> read_inputs(const InputOptions& options, Diagnostics& diagnostics) {
  auto read = read_robot_files(options.urdf, options.scene, diagnostics);
  if (!read) return std::nullopt;
  const std::vector<Function> functions = find_functions(options.functions, diagnostics);
  auto scene = parse_scene_of(*read, diagnostics, functions, options.functions_from);
  if (!scene) return std::nullopt;
  apply(options, read->files.scene_text, *scene, diagnostics);
  warn_of_limits(read->robot, *scene, options.limits_for, diagnostics);
  leave_out_singular(read->robot, *scene, place_of_list(read->files, functions), diagnostics);
  if (const PackageKind* const package = find_package(options.package)) {
    refuse_package(*package, read->robot, *scene, diagnostics);
  }
  complete_ground_step(*read, *scene, diagnostics);
  note_noise(build_mechanism(read->robot, *scene).noise, *scene, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return RobotAndScene{std::move(read->robot), std::move(*scene), std::move(read->files)};
}

}  // namespace treeline
