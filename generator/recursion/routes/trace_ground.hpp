#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Of each operational point the world's z axis in the point's axes, and the height of its origin:
/// four entries, of `q`. The caller gives programs of this header their names.
Program trace_heights(const Mechanism& mechanism, int lanes);

/// What the mechanism is at a pose for impulses at points near its operational points, of `q`:
/// positions and rotations of these, the motion [v; w] that each velocity makes, and the factors
/// of M = L^T D L: of each row of L the entries of the velocities that carry it, in the order of
/// `velocities_before`, and one over D. All places are relative to `origin`: a floating base's, so
/// that no digits are lost far from the world's. The mechanism has no mimic joints.
Program trace_for_impulses(const Mechanism& mechanism, int lanes);

/// Lists, for each velocity, the velocities that carry it, from the root outward.
std::vector<std::vector<int>> velocities_before(const Mechanism& mechanism);

/// Kinetic plus potential energy, of `q` and `qd`.
Program trace_energy(const Mechanism& mechanism, int lanes);

}  // namespace treeline
