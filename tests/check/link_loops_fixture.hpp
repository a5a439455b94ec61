#pragma once

#include "data/list_data.hpp"
#include "fixture.hpp"
#include "recursion/routes/trace_function.hpp"

// Tries functions that loop over a table of links, from the file to the compiled code, against 50
// digits and against their own bounds.

namespace treeline::tests {

inline const std::vector<Function> kDynamics = {Function::inverse_dynamics, Function::gravity,
                                                Function::nonlinear_effects, Function::mass_matrix,
                                                Function::forward_dynamics};
inline const std::vector<Function> kOfPoints = {Function::lambda_inverse, Function::lambda,
                                                Function::control_torque};

inline const char* const kPointAtWrist =
    "operational_points: [{name: wrist, link: gen3_end_effector_link}]\n";

/// The robot with these functions, all as loops, in the language and profile of its scene.
inline Subjects as_loops(Subjects subjects, Real real, std::vector<Function> functions) {
  subjects.scene.optimize = Optimize::size;
  subjects.scene.real = real;
  subjects.scene.lanes = 1;
  subjects.scene.damped.reset();
  subjects.scene.functions = std::move(functions);
  Choices choices;
  for (const Function function : subjects.scene.functions) choices.plain[function] = {kLoopsKey};
  Diagnostics diagnostics;
  auto generation =
      generate_code(subjects.robot, subjects.scene,
                    {"robot.urdf", "no text", "scene.yaml", "no text"}, diagnostics, choices);
  for (const Diagnostic& diagnostic : diagnostics.list()) ADD_FAILURE() << to_string(diagnostic);
  if (!generation) throw std::runtime_error("nothing generated");
  subjects.generation = std::move(*generation);
  return subjects;
}

inline std::vector<Function> all_with_form() {
  std::vector<Function> functions = kDynamics;
  functions.insert(functions.end(), kOfPoints.begin(), kOfPoints.end());
  std::sort(functions.begin(), functions.end());
  return functions;
}

inline void expect_right_in(const Subjects& unmade, Real real, const std::vector<Function>& of) {
  const Subjects subjects = as_loops(unmade, real, of);
  for (const GeneratedFunction& generated : subjects.generation.functions) {
    EXPECT_TRUE(generated.program.loops) << generated.program.name;
  }
  CheckOptions options = quick_options(24);
  options.compile.flags += " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror";
  const auto report = check_or_throw(subjects, options);
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.functions.size(), of.size());
  for (const FunctionReport& function : report.functions) {
    EXPECT_TRUE(function.bits_known) << function.name;
    EXPECT_EQ(function.bits_differ, 0) << function.name;
  }
}

/// Random robots take turns: half of the seeds are in C. Published ones are tried in both
/// languages.
inline Language language_of(std::uint64_t seed) {
  return seed % 4 < 2 ? Language::cpp : Language::c;
}

/// In both languages, whose loops are held to the bits of one graph.
inline void expect_right(Subjects unmade, Real real, const std::vector<Function>& of) {
  for (const Language language : {Language::cpp, Language::c}) {
    SCOPED_TRACE(language == Language::c ? "C" : "C++");
    unmade.scene.language = language;
    expect_right_in(unmade, real, of);
  }
}

/// Checks code of `profile: misra`, which may not have other bits either.
inline void expect_safe(Subjects unmade, Real real) {
  unmade.scene.profile = Profile::misra;
  expect_right(std::move(unmade), real, all_with_form());
}

inline Subjects read(const std::string& urdf, const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file(urdf), diagnostics);
  if (!robot) throw std::runtime_error("the robot cannot be read");
  const auto scene = parse_scene(scene_text, "scene.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error("the scene cannot be read");
  return {*robot, *scene, {}};
}

}  // namespace treeline::tests
