#pragma once

#include "emission/emission_context.hpp"
#include "text/diagnostic.hpp"

namespace treeline::c {

/// Reports what a scene asks for and C does not have: in `profile: misra` functions of several
/// states in one call, and a name whose header would stand before one of C's own.
void refuse(const EmissionContext& context, Diagnostics& diagnostics);

/// Reports a robot whose header NAME.h would stand before one of C's own.
void refuse_hidden_header(const EmissionContext& context, Diagnostics& diagnostics);

}  // namespace treeline::c
