#include "cli/generate_from_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "description/read_text_file.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) {
  const fs::path normal = fs::path(path).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

/// What the command line says instead of the scene, as it is typed.
std::string describe_options(const InputOptions& options) {
  std::string text;
  text += options.name.empty() ? "" : " --name " + options.name;
  text += options.real.empty() ? "" : " --real " + options.real;
  if (!options.functions.empty()) {
    text += fmt::format(" --functions {}", fmt::join(options.functions, ","));
  }
  return text;
}

}  // namespace

std::optional<GeneratedInputs> generate_from_files(const InputOptions& options,
                                                   Diagnostics& diagnostics) {
  auto inputs = read_inputs(options, diagnostics);
  if (!inputs) {
    return std::nullopt;
  }
  const auto urdf_text = read_text_file(options.urdf, diagnostics);
  const auto scene_text = read_text_file(options.scene, diagnostics);
  if (!urdf_text || !scene_text) {
    return std::nullopt;
  }
  auto generation = generate_code(inputs->robot, inputs->scene,
                                  {file_name(options.urdf), *urdf_text, file_name(options.scene),
                                   *scene_text, describe_options(options)},
                                  diagnostics);
  if (!generation) {
    return std::nullopt;
  }
  return GeneratedInputs{std::move(*inputs), std::move(*generation)};
}

}  // namespace treeline
