#include "cli/generate_from_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "generation/warnings.hpp"
#include "inspect/warn_of_rows.hpp"
#include "packaging/package_kinds.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/progress_line.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) {
  const fs::path normal = fs::path(path).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

/// Options that replace keys of the scene, as they are typed.
std::string describe_options(const InputOptions& options) {
  std::string text;
  text += options.name.empty() ? "" : " --name " + options.name;
  text += options.real.empty() ? "" : " --real " + options.real;
  text += options.language.empty() ? "" : " --language " + options.language;
  const PackageKind* const package = find_package(options.package);
  if (package != nullptr && !package->of_c.empty()) text += " --package " + options.package;
  text += options.profile.empty() ? "" : " --profile " + options.profile;
  text += options.optimize.empty() ? "" : " --optimize " + options.optimize;
  text += options.target.empty() ? "" : " --target " + options.target;
  if (!options.functions.empty()) {
    text += fmt::format(" --functions {}", fmt::join(options.functions, ","));
  }
  return text;
}

}  // namespace

Provenance provenance_of(const InputOptions& options, const RobotAndScene& inputs) {
  const RobotFiles& files = inputs.files;
  Provenance provenance{files.urdf.empty() ? "" : file_name(files.urdf), files.urdf_text,
                        files.scene.empty() ? "" : file_name(files.scene), files.scene_text,
                        describe_options(options)};
  for (const InputFile& file : files.scene_robots.files) {
    provenance.robots.push_back({file.name, file.text});
  }
  return provenance;
}

std::optional<GeneratedInputs> generate_from_files(const InputOptions& options, Failing failing,
                                                   Diagnostics& diagnostics) {
  auto inputs = read_inputs(options, diagnostics);
  if (!inputs) {
    return std::nullopt;
  }
  auto choices = std::make_optional<Choices>();
  if (!options.choices.empty()) {
    choices = read_choices(options.choices, inputs->robot.name, diagnostics);
  }
  if (!choices) return std::nullopt;
  return generate_from_inputs(options, std::move(*inputs), *choices, failing, diagnostics);
}

std::optional<GeneratedInputs> generate_from_inputs(const InputOptions& options,
                                                    RobotAndScene inputs, const Choices& choices,
                                                    Failing failing, Diagnostics& diagnostics) {
  const Provenance provenance = provenance_of(options, inputs);
  LateProgress progress;
  auto tried = generate_tried(
      inputs.robot, inputs.scene, provenance,
      {choices, [&](const std::string& what) { progress.show("  generating " + what); }, failing},
      diagnostics);
  if (!tried) return std::nullopt;
  inputs.scene = tried->generation.scene;
  return GeneratedInputs{std::move(inputs), std::move(tried->generation), std::move(tried->failed)};
}

void warn_beforehand(const InputOptions& options, const GeneratedInputs& made) {
  Diagnostics diagnostics;
  warn_of_size(made.inputs.scene, made.generation, diagnostics);
  warn_of_speed_rise(made.inputs.scene, made.generation, diagnostics);
  warn_of_rows(made.inputs.robot, made.inputs.scene, diagnostics);
  print_diagnostics(diagnostics, options.warnings);
}

}  // namespace treeline
