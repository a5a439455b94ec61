#pragma once

#include <optional>
#include <span>
#include <vector>

#include "oracle/equation_at.hpp"

namespace treeline {

/// Equations with a derivative, a row for each function that has one.
std::span<const Equation> equations_of_robot();
std::span<const Equation> equations_of_points();  ///< and of contacts
std::span<const Equation> equations_of_constraints();
std::span<const Equation> equations_of_objects();

/// The equation of a function; null where it has no derivative in it.
const Equation* find_equation(Function function);

/// How much the two sides of a function's equation differ at a state, relative to its terms:
/// `results` against what is found by differentiating lower functions in 50 digits. Nothing where
/// the function has no such equation, or it says nothing at this state.
std::optional<double> equation_residual(Function function, const Subject<Digits50>& subject,
                                        const State& state, const std::vector<Digits50>& results);

/// Residual of the interpreter's results in 50 digits, with rows of tasks solved as they are.
std::optional<double> equation_residual(Function function, const Subject<Digits50>& subject,
                                        const State& state);

}  // namespace treeline
