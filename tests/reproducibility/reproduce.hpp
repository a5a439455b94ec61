#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compilation/generated_library.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "oracle/reference.hpp"

namespace treeline::tests {

/// A way to compile emitted code.
struct Build {
  std::string compiler, flags;
};

/// A robot and a scene, the code generated from them, and states with the results that it must have
/// there.
struct Original {
  std::string name;
  Robot robot;
  Scene scene;
  Generation generation;
  std::vector<StateReference> references;
};

/// Difference of one function in one build from the original. The original is the expression graph
/// evaluated operation by operation or, for float compared with double, the code in double.
struct Difference {
  std::string robot, function;
  Build build;
  bool solves = false;  ///< has a solve: differences grow with the condition number
  int states = 0;       ///< number of states compared
  int bits_differ = 0;  ///< number of these in which any bit differs
  double worst = 0;     ///< largest difference in ulp of the result's scale, in the build's Real
  double share = 0;     ///< largest share of what `treeline check` allows in that state

  [[nodiscard]] bool bounded() const { return share <= 1; }
};

/// Loads robots/NAME with its scene.yaml, changed as the other arguments say. If `functions` is
/// empty, the scene's functions are used. Throws std::runtime_error if something cannot be read or
/// generated.
Original load_original(const std::string& robots, const std::string& name, int states,
                       const std::vector<Function>& functions, Real real = Real::float64,
                       int lanes = 8, int batch = 0);

/// Whether this compiler can be run on this machine.
bool has_compiler(const std::string& compiler);
/// Flags for this machine with which no product and sum are fused. When GCC 12 vectorizes
/// straight-line code, it forms fused operations of alternating sign (vfmsubadd), even with
/// -ffp-contract=off.
std::string separate_for_machine(const std::string& compiler);

/// Compiles the original's code by one build. Throws std::runtime_error with the compiler's
/// message.
GeneratedLibrary build_library(const Original& original, const Build& build);

/// Compares every function of a build with the expression graph. If `other` is given, this code for
/// the same functions is compiled instead of the original's.
std::vector<Difference> compare_with_graph(const Original& original, const Build& build,
                                           const Original* other = nullptr);

/// Compares every function in float with the same function in double, at the states of the float
/// version.
std::vector<Difference> compare_with_double(const Original& in_float, const Original& in_double,
                                            const Build& build);

/// Prints a line of names, then one line per difference.
std::string print_csv(const std::vector<Difference>& rows);
/// Prints a head and one line for each robot and build: functions, results and how many of these
/// have other bits, the largest difference of functions without a solve, and the largest difference
/// of all as a share of what is allowed.
std::string print_table(const std::vector<Difference>& rows);

}  // namespace treeline::tests
