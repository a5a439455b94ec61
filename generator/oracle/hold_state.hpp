#pragma once

#include "oracle/draw_state.hpp"

namespace treeline {

/// Moves a state to one that keeps the constraints, up to the rounding of double: q to the nearest
/// pose with closed loops, qd to the nearest velocities that hold the rows, with no stabilisation
/// and no drift. Returns false if Newton's method finds no such pose within the joints' limits.
bool hold_state(const StateSpace& space, State& state);

}  // namespace treeline
