#pragma once

#include <map>
#include <string>
#include <vector>

#include "data/list_data.hpp"
#include "description/scene.hpp"

/// Results of Treeline for a published robot, one row of the compatibility page.
namespace treeline::tests {

/// A robot with a base, as named by the page and its tests: `fetch`, fixed.
struct CompatibilityCase {
  DataRobot robot;
  Base base = Base::fixed;

  [[nodiscard]] std::string robot_name() const;  ///< `fetch`
  [[nodiscard]] std::string base_name() const;   ///< `fixed`
};

/// Lists every robot of tests/data/published, with a fixed and with a floating base.
std::vector<CompatibilityCase> compatibility_cases();

struct CompatibilityRow {
  CompatibilityCase of;
  std::string failure;  ///< why nothing was generated; empty if it was
  int freedoms = 0;
  int asked = 0;                              ///< number of functions in the scene
  std::map<std::string, int> operations;      ///< by function
  std::map<std::string, std::string> digits;  ///< remaining digits, by function; `-` for none
  double seconds = 0;                         ///< processor time of generation on this machine
};

/// Reads the robot, makes a scene for it, and generates all its functions. With `with_digits` it
/// also measures their digits (see digits.hpp), which takes longer.
CompatibilityRow measure_row(const CompatibilityCase& of, bool with_digits);

}  // namespace treeline::tests
