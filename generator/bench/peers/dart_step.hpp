#pragma once

#include "bench/peers/dart_solver.hpp"
#include "bench/peers/make_peer.hpp"

namespace treeline::peer {

/// Adds DART's nearest to forward dynamics with rows held. It holds velocities, by impulses in a
/// step of its world: the motion is their change over a short step.
void add_held_step(const Robot& robot, const Tell& tell, const Solver& s, Opened& opened);

}  // namespace treeline::peer
