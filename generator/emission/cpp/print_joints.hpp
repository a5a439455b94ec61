#pragma once

#include <string>

#include "emission/emission_context.hpp"

namespace treeline::cpp {

/// NAME_joints.hpp: names and limits of coordinates, velocities and task rows as constexpr arrays.
std::string print_joints(const EmissionContext& context);

}  // namespace treeline::cpp
