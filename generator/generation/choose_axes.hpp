#pragma once

#include <optional>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// The function whose operations decide how links are gone about in `function`: itself where it is
/// one recursion, forward dynamics where inertias and motions both count. None: nothing is chosen.
std::optional<Function> axes_decider(Function function);

/// Decides for each link in which axes recursions work with it and how they get its angular
/// acceleration, `turns_late` and `carries_column`: by coordinate descent on the operations of
/// `decider` as traced. Alike limbs decide together, so that they can share lanes.
void choose_axes(Mechanism& mechanism, Function decider);

}  // namespace treeline
