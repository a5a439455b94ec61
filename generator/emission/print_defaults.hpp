#pragma once

#include <map>
#include <string>

#include "emission/emission_context.hpp"

namespace treeline {

/// Text for the holes of a template, by name.
using Holes = std::map<std::string, std::string>;

/// Adds the numbers of an emitted controller: the configuration's defaults in the order of its
/// members, which joints turn without end, and which rows of the points it controls.
void add_controller_numbers(const EmissionContext& context, const ControllerUnit& unit,
                            Holes& holes);

}  // namespace treeline
