#pragma once

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Number of operations of `function` by its cheapest route as traced.
int count_cheapest(const Mechanism& mechanism, Function function);

/// Decides for each link in which axes recursions treat it and how they compute its angular
/// acceleration (`defers_rotation` and `carries_column`), by coordinate descent on the number of
/// operations of `frame_cost` as traced. Isomorphic limbs decide together, so that they can share
/// lanes.
void choose_axes(Mechanism& mechanism, Function frame_cost);

}  // namespace treeline
