#include "oracle/bound.hpp"

#include <algorithm>
#include <cmath>

namespace treeline {

Bound find_bound(std::size_t i, Function function, const std::vector<StateReference>& references) {
  Bound bound;
  bound.solve = solve_of(function);
  for (const StateReference& reference : references) {
    const FunctionReference& at = reference.functions[i];
    const double error = at.interpreter_error / at.amplification;
    // If the interpreter itself fails at a state, that state says nothing about the tolerance.
    if (!at.singular && std::isfinite(error)) {
      bound.interpreter = std::max(bound.interpreter, error);
    }
  }
  return bound;
}

}  // namespace treeline
