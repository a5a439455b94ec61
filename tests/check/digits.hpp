#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline::tests {

/// A robot with a scene whose functions are measured.
struct DigitsSubject {
  std::string name;   ///< `golden/anymal`, `puma560/scene_float`
  std::string urdf;   ///< path
  std::string scene;  ///< path; empty: one is made
};

/// Lists all robots of `robots` with their scenes, and those of tests/data.
std::vector<DigitsSubject> list_subjects(const std::string& robots);

/// Makes a scene for a robot that has none. Its operational points are end links, at most two, each
/// with as many rows as the link can move independently. Without `base`, the base floats if there
/// are four end links or more, or if nothing else moves.
std::optional<Scene> make_scene(const Robot& robot, std::optional<Base> base = {});

/// Digits that a function keeps at the worst of a few states of every class; none if no state keeps
/// any.
struct DigitsLeft {
  std::string subject, function;
  std::optional<double> digits;
};

/// Measures the digits of each function of the subject, including those about objects and the
/// damped one. The expression graph of the cheapest route is evaluated in the scene's Real and
/// compared with 50 digits, so the digits are those of emitted code except for reassociation by the
/// passes. States whose condition number leaves no digit are left out. Throws std::runtime_error if
/// a file cannot be read.
std::vector<DigitsLeft> measure_digits(const DigitsSubject& subject);
std::vector<DigitsLeft> measure_digits(const std::string& subject, const Robot& robot,
                                       const Scene& scene);

/// Prints `subject,function,digits` with a line of names. Digits are rounded to a tenth, `-` means
/// none.
std::string print_digits(const std::vector<DigitsLeft>& rows);
std::vector<DigitsLeft> read_digits(const std::string& path);

}  // namespace treeline::tests
