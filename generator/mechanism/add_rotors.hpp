#pragma once

#include <map>
#include <string>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// Adds the inertia (kg m^2, kg for sliding joints) of rotors to their joints, by name. A rotor
/// turns with its joint's coordinate but is carried by the world, so that it adds its inertia to
/// that coordinate's entry on the diagonal of M, and nothing else: no weight, no gyroscopic moment.
/// This is the usual model of a motor behind a large gear ratio (RBDA section 9.6).
void add_rotors(const std::map<std::string, double>& armature, Mechanism& mechanism);

}  // namespace treeline
