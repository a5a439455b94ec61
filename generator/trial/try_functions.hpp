#pragma once

#include <array>
#include <string>
#include <vector>

#include "choice/choose_functions.hpp"
#include "functions/function.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// States of every class at which functions are tried: neutral, at rest and moving, where many arms
/// are singular; ordinary; near quarter turns, where more are singular; fast; many turns; tiny; at
/// limits.
inline constexpr std::array kTrialStates = {0, 20, 1, 4, 2, 7, 11, 3, 5, 6, 19, 39};

/// States at which functions are tried.
struct TrialOptions {
  std::vector<int> states{kTrialStates.begin(), kTrialStates.end()};
  /// Number of first states at which failures are tried again: those of `check`, whose verdict on
  /// the same code is then the same.
  int confirm = ReferenceOptions{}.states;
  std::uint64_t seed = 1;
};

/// A function whose expression graph, evaluated in Real, exceeds its bound at a state.
struct FailedTrial {
  Function function{};
  std::string name;  ///< see `source_stem`
  State state;
  double error = 0, bound = 0;  ///< in ulp of the result's scale
};

/// Evaluates the graph of each function exactly as emitted code would, to the bit, and compares it
/// with the interpreter in 50 digits, within the bounds of `check`. Where the task is singular and
/// relaxed, the result must be finite. Nothing is compiled. Returns the functions that fail, each
/// with the state at which it exceeds its bound the most. The bound depends on the interpreter's
/// errors in Real, which a few states may underestimate. So a function that fails at the few states
/// is judged again at all states of `check`.
///
/// The 50 digits are computed only where they can change the verdict, which is almost nowhere. The
/// bound is 8 ulp plus 16 times the interpreter's own error in Real. So a graph within 8 ulp of the
/// interpreter in Real is within its bound, whatever that error is.
std::vector<FailedTrial> try_functions(const Robot& robot, const Scene& scene,
                                       const ChosenFunctions& chosen,
                                       const TrialOptions& options = {});

}  // namespace treeline
