#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline::tests {

/// A robot with a scene whose functions are to be looked at.
struct DigitsSubject {
  std::string name;   ///< `golden/anymal`, `puma560/scene_float`
  std::string urdf;   ///< path
  std::string scene;  ///< path; empty: one is made
};

/// All robots of `robots` with their scenes, and those of tests/data.
std::vector<DigitsSubject> list_subjects(const std::string& robots);

/// A scene for a robot that has none: as many of its end links as operational points, two at most,
/// as many rows as the links can move with. Without `base`, it floats where there are four end
/// links or more, or where nothing else moves.
std::optional<Scene> make_scene(const Robot& robot, std::optional<Base> base = {});

/// What a function leaves at the worst of a few states of every class; no digits where no state
/// leaves any.
struct DigitsLeft {
  std::string subject, function;
  std::optional<double> digits;
};

/// Of each function of the subject, objects' and damped ones as well, from the cheapest route's
/// expression graph evaluated in the scene's Real against 50 digits: what emitted code gives but
/// for the passes' reassociations. In states where the condition leaves no digit nothing is
/// measured. Throws std::runtime_error for files that cannot be read.
std::vector<DigitsLeft> measure_digits(const DigitsSubject& subject);
std::vector<DigitsLeft> measure_digits(const std::string& subject, const Robot& robot,
                                       const Scene& scene);

/// `subject,function,digits` with a line of names; digits to a tenth, `-` for none.
std::string print_digits(const std::vector<DigitsLeft>& rows);
std::vector<DigitsLeft> read_digits(const std::string& path);

}  // namespace treeline::tests
