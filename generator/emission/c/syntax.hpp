#pragma once

#include "emission/emission_context.hpp"
#include "emission/syntax.hpp"

namespace treeline::c {

/// C99, numbers of type double or float.
Syntax make_syntax(const EmissionContext& context);

/// How functions of several states are written in vectors.
Syntax make_states_syntax(const EmissionContext& context);

}  // namespace treeline::c
