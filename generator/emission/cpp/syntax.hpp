#pragma once

#include "emission/emission_context.hpp"
#include "emission/syntax.hpp"

namespace treeline::cpp {

/// C++17, numbers of type Real.
Syntax make_syntax(bool single_precision);
Syntax make_syntax(const EmissionContext& context);

/// Syntax of C++17 for functions of several states at once; their numbers have type `States`.
Syntax make_states_syntax(const EmissionContext& context);

}  // namespace treeline::cpp
