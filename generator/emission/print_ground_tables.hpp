#pragma once

#include <string>

#include "emission/adapt.hpp"
#include "emission/emission_context.hpp"
#include "emission/ground_unit.hpp"

namespace treeline {

/// Sizes that runtime/emitted/ground_robot.h lists, and how many entries a factor has.
std::string print_ground_sizes(const GroundUnit& unit, const Adaptation& own);

/// Its tables: what of the robot may touch the ground, and which velocities move it.
std::string print_ground_tables(const EmissionContext& context, const GroundUnit& unit);

}  // namespace treeline
