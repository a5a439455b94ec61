#pragma once

#include <array>
#include <string>
#include <vector>

#include "functions/function.hpp"
#include "generation/generate_code.hpp"
#include "oracle/draw_state.hpp"

namespace treeline {

/// States of every class that functions are tried at: neutral, at rest and moving, where many arms
/// are singular; ordinary; next to quarter turns, where more are; fast; turned many times; tiny; at
/// limits.
inline constexpr std::array kTrialStates = {0, 20, 1, 4, 2, 7, 11, 3, 5, 6, 19, 39};

/// Which states functions are tried at.
struct TrialOptions {
  std::vector<int> states{kTrialStates.begin(), kTrialStates.end()};
  int confirm = 200;  ///< what is beyond its bound there is tried once more at the first so many
  std::uint64_t seed = 1;
};

/// A function whose expression graph, evaluated in Real, leaves its bound at a state.
struct FailedTrial {
  Function function{};
  std::string name;  ///< as `source_stem` has it
  State state;
  double error = 0, bound = 0;  ///< in ulp of the result's scale
};

/// Evaluates the graph of each function as emitted code would, to the bit, and compares it with the
/// interpreter in 50 digits, within the bounds of `check`; where the task is singular and yields,
/// it must be finite. Nothing is compiled. Returns the functions that fail, each at the state where
/// it leaves its bound the farthest. The bound rests on what the interpreter errs by in Real, which
/// few states can understate; so a function that fails at few is judged again at many.
///
/// The 50 digits are computed where they can change the verdict, mostly nowhere: the bound is 8 ulp
/// and 16 times the interpreter's own error in Real, so that a graph within 8 ulp of the
/// interpreter in Real is within its bound whatever that error is.
std::vector<FailedTrial> try_functions(const Robot& robot, const Scene& scene,
                                       const Generation& generation,
                                       const TrialOptions& options = {});

}  // namespace treeline
