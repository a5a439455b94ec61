#pragma once

#include <string>
#include <string_view>

#include "emission/emission_context.hpp"

namespace treeline::cpp {

/// A header of runtime/core in the robot's own namespace, so that robots generated at different
/// times live in one program, and in one folder with those that it includes.
std::string print_core_header(const EmissionContext& context, std::string_view header);

}  // namespace treeline::cpp
