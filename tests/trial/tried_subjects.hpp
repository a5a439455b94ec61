#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "check/fixture.hpp"
#include "trial/try_functions.hpp"

namespace treeline::tests {

/// The functions that leave their bounds when they are tried, of which there should be none.
inline std::vector<std::string> failing(const Subjects& subjects, const Generation& generation) {
  TrialOptions options;
  options.confirm = 40;
  std::vector<std::string> names;
  for (const FailedTrial& each :
       try_functions(subjects.robot, subjects.scene, generation, options)) {
    EXPECT_GT(each.error, each.bound) << each.name;
    names.push_back(each.name);
  }
  return names;
}

/// Reads a robot and a scene from text, for which nothing is generated yet.
inline Subjects read_unmade(const std::string& urdf, const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf("<robot name='r'>" + urdf + "</robot>", "r.urdf", diagnostics);
  if (!robot) throw std::runtime_error(to_string(diagnostics.list().back()));
  const auto scene = parse_scene(scene_text, "s.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error(to_string(diagnostics.list().back()));
  return {*robot, *scene, {}};
}

/// A robot and a scene from their texts, with the code.
inline Subjects read(const std::string& urdf, const std::string& scene_text) {
  Subjects subjects = read_unmade(urdf, scene_text);
  subjects.generation = generate(subjects.robot, subjects.scene);
  return subjects;
}

}  // namespace treeline::tests
