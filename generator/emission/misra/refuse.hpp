#pragma once

#include "description/diagnostic.hpp"
#include "emission/emission_context.hpp"

namespace treeline::misra {

/// Reports what `profile: misra` is asked for and does not have.
void refuse(const EmissionContext& context, Diagnostics& diagnostics);

}  // namespace treeline::misra
