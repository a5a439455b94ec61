#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bench/variant.hpp"
#include "check/compile_folder.hpp"
#include "check/generated_library.hpp"
#include "description/robot.hpp"
#include "oracle/draw_state.hpp"
#include "timing/time_calls.hpp"

namespace treeline {

/// A variant that can be run.
struct Contender {
  Variant variant;
  /// The entries of all results at a state, one after the other.
  std::function<std::vector<double>(const State&)> call;
  TimedPass pass;  ///< over the states that are timed
};

/// A build's variants, compiled in a folder `work` that is made for it and loaded. Contenders keep
/// the library. Errors: see `load_build`. `command`, where it is given, gets compiler and flags.
std::optional<std::vector<Contender>> compile_contenders(const VariantBuild& build,
                                                         const std::vector<State>& timed,
                                                         const std::filesystem::path& work,
                                                         std::string* command,
                                                         Diagnostics& diagnostics);

/// The generic interpreter in double and float, with all that it allocates.
std::vector<Contender> interpreter_contenders(const Robot& robot, const Scene& scene,
                                              const std::vector<State>& timed);

/// Lambda by Eigen's LU with partial pivoting and by its LDL^T, as a matrix whose size is known
/// when it runs only, out of Lambda^-1 as `lambda_inverse` gives it in double with so many rows.
std::vector<Contender> factorisation_contenders(const Contender& lambda_inverse, int rows);

/// The state with its sines and cosines rounded to double, not to float.
State with_double_sines(State state);

}  // namespace treeline
