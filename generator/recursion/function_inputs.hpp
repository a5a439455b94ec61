#pragma once

#include "functions/function.hpp"

namespace treeline {

/// Arguments beside q.
enum Inputs : unsigned { kQd = 1, kQdd = 2, kTau = 4, kXddCmd = 8, kForces = 16, kPosture = 32 };

/// Of a function that is about the robot or its points, out of `Inputs`.
unsigned inputs_of(Function function);

}  // namespace treeline
