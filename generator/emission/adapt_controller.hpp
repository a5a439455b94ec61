#pragma once

#include "emission/adapt.hpp"
#include "emission/controller_unit.hpp"

namespace treeline {

/// How the headers of a controller are written for a robot. For a reference their numbers are of a
/// type `Real`.
Adaptation adapt_controller(const EmissionContext& context, const ControllerUnit& unit,
                            bool for_reference);

}  // namespace treeline
