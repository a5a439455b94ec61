#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// The functions whose operations may decide how links are gone about in `function`: itself where
/// it is one recursion, forward dynamics where inertias and motions both count; of several the one
/// that leaves `function` cheapest. None: nothing is chosen. Derivatives would be slow to trace for
/// every choice, and what that saved of their operations cost them lanes (measured).
std::vector<Function> axes_deciders(Function function);

/// Operations of `function` by its cheapest route as traced.
int count_cheapest(const Mechanism& mechanism, Function function);

/// Decides for each link in which axes recursions work with it and how they get its angular
/// acceleration, `turns_late` and `carries_column`: by coordinate descent on the operations of
/// `decider` as traced. Alike limbs decide together, so that they can share lanes.
void choose_axes(Mechanism& mechanism, Function decider);

}  // namespace treeline
