#pragma once

#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Frame cost functions: those whose operations may decide the axes of links for `function`. This
/// is the function itself if it is one recursion, and forward dynamics if inertias and motions both
/// matter. If there are several, the one that makes `function` cheapest wins; if there are none,
/// nothing is chosen. Derivatives have none: tracing them for every choice would be slow, and what
/// was saved in operations was lost in lanes (measured).
std::vector<Function> axes_deciders(Function function);

/// Number of operations of `function` by its cheapest route as traced.
int count_cheapest(const Mechanism& mechanism, Function function);

/// Decides for each link in which axes recursions treat it and how they compute its angular
/// acceleration (`turns_late` and `carries_column`), by coordinate descent on the number of
/// operations of `decider` as traced. Isomorphic limbs decide together, so that they can share
/// lanes.
void choose_axes(Mechanism& mechanism, Function decider);

}  // namespace treeline
