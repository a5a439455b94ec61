#pragma once

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Operations of `function` by its cheapest route as traced.
int count_cheapest(const Mechanism& mechanism, Function function);

/// Decides for each link in which axes recursions work with it and how they get its angular
/// acceleration, `turns_late` and `carries_column`: by coordinate descent on the operations of
/// `decider` as traced. Alike limbs decide together, so that they can share lanes.
void choose_axes(Mechanism& mechanism, Function decider);

}  // namespace treeline
