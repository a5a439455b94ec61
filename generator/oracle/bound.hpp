#pragma once

#include <vector>

#include "functions/function.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// The error of one function at one state, in ulp of the scale, beside what is allowed.
struct ErrorAt {
  int state = 0;
  double error = 0;
  double bound = 0;
  double condition = 1;
};

/// What a function's outputs are allowed to differ by, in ulp of their scale:
/// kFloorUlp + angles + condition * kInterpreterFactor * interpreter, where `angles` is
/// FunctionReference::computed_angles and `interpreter` the largest error over condition that the
/// interpreter made in Real at any of the states.
struct Bound {
  static constexpr double kFloorUlp = 8;
  static constexpr double kInterpreterFactor = 16;
  Solve solve = Solve::none;
  double interpreter = 0;

  [[nodiscard]] double at(const FunctionReference& reference) const {
    return kFloorUlp + reference.computed_angles +
           reference.condition * kInterpreterFactor * interpreter;
  }
};

/// What the interpreter's errors at these states allow function `i`.
Bound find_bound(std::size_t i, Function function, const std::vector<StateReference>& references);

}  // namespace treeline
