#pragma once

#include <string>
#include <utility>
#include <vector>

#include "check/fixture.hpp"

namespace treeline::tests {

/// Generates these functions of one of our robots.
inline Subjects load_functions(const std::string& name, std::vector<Function> functions,
                               Sines sines = Sines::computed) {
  const std::string folder = std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/";
  Diagnostics diagnostics;
  Subjects made{read_urdf(folder + name + ".urdf", diagnostics).value(), {}, {}};
  made.scene = read_scene(folder + "scene.yaml", made.robot, diagnostics).value();
  made.scene.damped.reset();
  made.scene.sin_cos = sines;
  made.scene.functions = std::move(functions);
  made.generation = generate(made.robot, made.scene);
  return made;
}

/// Draws a random robot and generates these functions of it.
inline Subjects draw_functions(std::uint64_t seed, const RandomOptions& options,
                               std::vector<Function> functions) {
  RandomMechanism drawn = random_mechanism(seed, options);
  drawn.scene.functions = std::move(functions);
  return {drawn.robot, drawn.scene, generate(drawn.robot, drawn.scene)};
}

}  // namespace treeline::tests
