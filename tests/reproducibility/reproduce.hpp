#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/generated_library.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "oracle/reference.hpp"

namespace treeline::tests {

/// How emitted code is compiled.
struct Build {
  std::string compiler, flags;
};

/// A robot and a scene, what is generated from them, and states with what must come out there.
struct Original {
  std::string name;
  Robot robot;
  Scene scene;
  Generation generation;
  std::vector<StateReference> references;
};

/// What one build made of one function: how far it is from the original, which is the expression
/// graph evaluated operation by operation, or, for float against double, double's code.
struct Difference {
  std::string robot, function;
  Build build;
  bool solves = false;  ///< the function solves with a matrix: differences grow with its condition
  int states = 0;       ///< at which the two were compared
  int bits_differ = 0;  ///< of these, where any bit differs
  double worst = 0;     ///< largest difference in ulp of the result's scale, in the build's Real
  double share = 0;     ///< largest difference over what `treeline check` allows at that state

  [[nodiscard]] bool bounded() const { return share <= 1; }
};

/// robots/NAME with its scene.yaml, but for what the other arguments say; with the scene's
/// functions where `functions` is empty. Throws std::runtime_error for what cannot be read or
/// generated.
Original load_original(const std::string& robots, const std::string& name, int states,
                       const std::vector<Function>& functions, Real real = Real::float64,
                       int lanes = 8, int batch = 0);

/// Whether this compiler can be run here.
bool has_compiler(const std::string& compiler);
/// What to compile with for this machine so that no product and sum is fused. When GCC 12
/// vectorizes straight-line code it forms fused operations of alternating sign (vfmsubadd),
/// -ffp-contract=off or not.
std::string separate_for_machine(const std::string& compiler);

/// The original's code by one build; throws std::runtime_error with the compiler's words.
GeneratedLibrary build_library(const Original& original, const Build& build);

/// Every function of a build against the expression graph. `other`: code for the same functions,
/// made otherwise, is compiled instead of the original's.
std::vector<Difference> compare_with_graph(const Original& original, const Build& build,
                                           const Original* other = nullptr);

/// Every function in float against the same function in double at the float's states.
std::vector<Difference> compare_with_double(const Original& in_float, const Original& in_double,
                                            const Build& build);

/// A row of names, then one a difference.
std::string print_csv(const std::vector<Difference>& rows);
/// One line for each robot and build, below a head: functions, results and how many of these have
/// other bits, the largest difference of functions that solve nothing, and of all in parts of what
/// is allowed.
std::string print_table(const std::vector<Difference>& rows);

}  // namespace treeline::tests
