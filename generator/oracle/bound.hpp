#pragma once

#include <vector>

#include "functions/function.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Error of one function at one state, and the error that is allowed there, in ulp of the result's
/// scale.
struct ErrorAt {
  int state = 0;
  double error = 0;
  double bound = 0;
  double condition = 1, amplification = 1;  ///< see `FunctionReference`
};

/// Largest error that a function's outputs may have, in ulp of their scale: kFloorUlp + angles +
/// steps + amplification * kInterpreterFactor * interpreter. Here `angles` and `steps` are
/// FunctionReference::computed_angles and border_steps, and `interpreter` the largest ratio of
/// error to amplification that the interpreter, run in Real, had at any state.
struct Bound {
  static constexpr double kFloorUlp = 8;
  static constexpr double kInterpreterFactor = 16;
  Solve solve = Solve::none;
  double interpreter = 0;

  [[nodiscard]] double at(const FunctionReference& reference) const {
    return kFloorUlp + reference.computed_angles + reference.border_steps +
           reference.amplification * kInterpreterFactor * interpreter;
  }
};

/// Bound of function `i` that follows from the interpreter's errors at these states.
Bound find_bound(std::size_t i, Function function, const std::vector<StateReference>& references);

}  // namespace treeline
