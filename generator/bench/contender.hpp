#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bench/variant.hpp"
#include "compilation/compile_folder.hpp"
#include "compilation/generated_library.hpp"
#include "description/robot.hpp"
#include "oracle/draw_state.hpp"
#include "timing/time_calls.hpp"

namespace treeline {

/// A variant that can be run.
struct Contender {
  Variant variant;
  /// Returns the entries of all results at a state, one after the other.
  std::function<std::vector<double>(const State&)> call;
  /// One pass over the states for timing, of each place in memory where the code lies.
  std::vector<TimedPass> passes;
  std::optional<CompiledFunction> compiled = {};  ///< of code that was compiled for this
};

/// Compiles the variants of a build in the folder `work`, which is created for it, and loads them.
/// The contenders keep the library loaded, `places` times, each at addresses of its own. Errors:
/// see `load_build`. `command`, if given, receives compiler and flags.
std::optional<std::vector<Contender>> compile_contenders(const VariantBuild& build,
                                                         const std::vector<State>& timed,
                                                         const std::filesystem::path& work,
                                                         int places, std::string* command,
                                                         Diagnostics& diagnostics);

/// Contenders that run the generic interpreter in double and float, including all its allocations.
std::vector<Contender> interpreter_contenders(const Robot& robot, const Scene& scene,
                                              const std::vector<State>& timed);

/// Contenders that compute Lambda by Eigen's LU with partial pivoting and by its LDL^T, on a matrix
/// whose size is known only at run time. They start from Lambda^-1, which `lambda_inverse` computes
/// in double with `rows` rows.
std::vector<Contender> factorisation_contenders(const Contender& lambda_inverse, int rows);

/// Returns the state with sines and cosines rounded to double instead of float.
State with_double_sines(State state);

}  // namespace treeline
