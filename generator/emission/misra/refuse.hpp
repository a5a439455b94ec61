#pragma once

#include "emission/emission_context.hpp"
#include "text/diagnostic.hpp"

namespace treeline::misra {

/// Reports what `profile: misra` is asked for and does not have.
void refuse(const EmissionContext& context, Diagnostics& diagnostics);

}  // namespace treeline::misra
