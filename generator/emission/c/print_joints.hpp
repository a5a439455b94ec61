#pragma once

#include <string>

#include "emission/emission_context.hpp"

namespace treeline::c {

/// NAME_joints.h: names and limits of coordinates, velocities and task rows as constant arrays.
std::string print_joints(const EmissionContext& context);

}  // namespace treeline::c
