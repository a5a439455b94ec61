#include <algorithm>

#include "oracle/equations.hpp"
#include "oracle/interpret.hpp"

namespace treeline {

const Equation* find_equation(Function function) {
  for (const auto rows : {equations_of_robot(), equations_of_points(), equations_of_constraints(),
                          equations_of_objects()}) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [=](const Equation& row) { return row.function == function; });
    if (found != rows.end()) return &*found;
  }
  return nullptr;
}

std::optional<double> equation_residual(Function function, const Subject<Digits50>& subject,
                                        const State& state, const std::vector<Digits50>& results) {
  const Equation* const equation = find_equation(function);
  if (equation == nullptr) return std::nullopt;
  const EquationSides sides = equation->sides(EquationAt(subject, state, results));
  if (sides.stated.size() == 0) return std::nullopt;
  const Digits50 terms =
      std::max({sides.terms, largest_of(sides.stated), largest_of(sides.differentiated)});
  if (terms == 0) return 0;
  if (!isfinite(terms)) return std::nullopt;
  return static_cast<double>(Digits50(largest_of(sides.stated - sides.differentiated) / terms));
}

std::optional<double> equation_residual(Function function, const Subject<Digits50>& subject,
                                        const State& state) {
  if (find_equation(function) == nullptr) return std::nullopt;
  return equation_residual(function, subject, state, interpret<Digits50>(function, subject, state));
}

}  // namespace treeline
