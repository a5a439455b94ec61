#pragma once

#include "emission/backend/syntax.hpp"
#include "emission/emission_context.hpp"

namespace treeline::cpp {

/// C++17, numbers of type Real.
Syntax make_syntax(bool single_precision);
Syntax make_syntax(const EmissionContext& context);

/// The same for functions of several states at once, whose numbers are `States`.
Syntax make_states_syntax(const EmissionContext& context);

}  // namespace treeline::cpp
