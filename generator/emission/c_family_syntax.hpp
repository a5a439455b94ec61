#pragma once

#include <string>
#include <string_view>

#include "emission/emission_context.hpp"
#include "emission/syntax.hpp"

namespace treeline {

/// Syntax that C and languages made from it have in common: comments, literals, signs, assignments
/// and constants. Numbers, lanes and sines are left to fill in.
Syntax make_c_family_syntax(bool single_precision);

/// A number as it is written, as a literal of the context's type: `0.25`, `0.25F`.
std::string number_literal(const EmissionContext& context, const char* digits);

/// A number with its sign, which 0 has none of.
std::string signed_literal(const Syntax& syntax, double value);

/// Changes the syntax as rules for safe code ask: suffixes in capitals, all parentheses.
void follow_misra(bool single_precision, Syntax& syntax);

/// `inverse_dynamics`: `InverseDynamics`.
std::string in_pascal_case(std::string_view name);
/// `MotionWork`: `motion_work`.
std::string in_snake_case(std::string_view name);
/// The robot's name in capitals, as constants and macros begin: `PUMA560`.
std::string name_in_capitals(const EmissionContext& context);

}  // namespace treeline
