#pragma once

#include "description/mjcf/read_bodies.hpp"

namespace treeline {

/// Sets the limits of effort of joints that motors of `<actuator>` drive, from their ranges of
/// force, or of control where that is a force, and their gears; and adds the inertia that they
/// state. Actuators that do not drive one joint are warnings.
void read_actuators(const std::vector<MjcfElement>& sections, const MjcfCompiler& compiler,
                    MjcfTree& tree);

/// What a range of forces bounds either way: its smaller end, with a note where the ends differ.
/// Infinite where it does not hold.
double bound_of(const MjcfElement& element, const char* range, const char* limited,
                const MjcfCompiler& compiler);

}  // namespace treeline
