#pragma once

#include <string>

#include "emission/controller_unit.hpp"
#include "emission/emission_context.hpp"

namespace treeline {

/// Prints NAME_controller.h: the contract of the controller's step, its types and its functions.
std::string print_controller_header(const EmissionContext& context, const ControllerUnit& unit);

}  // namespace treeline
