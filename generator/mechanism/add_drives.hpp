#pragma once

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Puts rotors, friction and springs of the scene into their joints. A rotor adds its inertia to
/// its coordinate's entry on the diagonal of M and nothing else, no weight and no gyroscopic
/// moment: the usual model of a motor behind a large gear ratio (RBDA section 9.6). Of a joint that
/// mimics, position = m q + o, a coordinate feels m^2 times the inertia, damping and stiffness.
void add_drives(const Scene& scene, Mechanism& mechanism);

}  // namespace treeline
