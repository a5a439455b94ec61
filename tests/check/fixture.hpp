#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include "check/check.hpp"
#include "compilation/temporary_folder.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "emission/write_files.hpp"
#include "random_mechanism.hpp"

namespace treeline::tests {

/// A robot and a scene with the code generated from them.
struct Subjects {
  Robot robot;
  Scene scene;
  Generation generation;
};

inline Generation generate(const Robot& robot, const Scene& scene) {
  Diagnostics diagnostics;
  auto generation =
      generate_code(robot, scene, {"robot.urdf", "no text", "scene.yaml", "no text"}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.severity == Severity::error) ADD_FAILURE() << to_string(diagnostic);
  }
  if (!generation) throw std::runtime_error("nothing generated");
  return std::move(*generation);
}

/// Loads robots/NAME with one of its scenes, for which nothing is generated yet.
inline Subjects load_unmade(const std::string& name, const std::string& scene_file) {
  const std::string folder = std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/";
  Diagnostics diagnostics;
  const auto robot = read_urdf(folder + name + ".urdf", diagnostics);
  if (!robot) throw std::runtime_error(name + " cannot be read");
  const auto scene = read_scene(folder + scene_file, *robot, diagnostics);
  if (!scene) throw std::runtime_error(scene_file + " cannot be read");
  return {*robot, *scene, {}};
}

/// A robot of `robots/` with its scene and its code.
inline Subjects load(const std::string& name, const std::string& scene_file = "scene.yaml") {
  Subjects loaded = load_unmade(name, scene_file);
  loaded.generation = generate(loaded.robot, loaded.scene);
  return loaded;
}

/// A robot in a scene of this text, with its code.
inline Subjects in_scene(const std::optional<Robot>& robot, const std::string& scene_text) {
  if (!robot) throw std::runtime_error("the robot cannot be read");
  Diagnostics diagnostics;
  const auto scene = parse_scene(scene_text, "scene.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error(to_string(diagnostics.list().front()));
  return {*robot, *scene, generate(*robot, *scene)};
}

/// Reads a robot in a file likewise.
inline Subjects in_scene(const std::string& urdf, const std::string& scene_text) {
  Diagnostics diagnostics;
  return in_scene(read_urdf(urdf, diagnostics), scene_text);
}

/// Draws a random robot and asks for the functions that it always has. On a fixed base a point may
/// have rows that no joint moves, and then Lambda does not exist.
inline Subjects draw(std::uint64_t seed, const RandomOptions& options, Real real = Real::float64) {
  RandomMechanism drawn = random_mechanism(seed, options);
  Subjects made{drawn.robot, drawn.scene, {}};
  made.scene.real = real;
  if (!options.floating_base) {
    std::erase(made.scene.functions, Function::lambda);
    std::erase(made.scene.functions, Function::control_torque);
  }
  made.generation = generate(made.robot, made.scene);
  return made;
}

/// Few states and a compiler that does not optimize, to be quick.
inline CheckOptions quick_options(int states = 40) {
  CheckOptions options;
  options.references.states = states;
  options.compile.flags = "-O0 -ffp-contract=off";
  return options;
}

inline CheckReport check_or_throw(const Subjects& subjects, const CheckOptions& options) {
  Diagnostics diagnostics;
  const auto report =
      check(subjects.robot, subjects.scene, subjects.generation, options, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.list()) ADD_FAILURE() << to_string(diagnostic);
  if (!report) throw std::runtime_error("nothing checked");
  return *report;
}

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline void write_folder(const std::filesystem::path& folder, const Generation& generation) {
  Diagnostics diagnostics;
  ASSERT_TRUE(write_files(folder, generation.files, diagnostics));
}

}  // namespace treeline::tests
