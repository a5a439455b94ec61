#pragma once

#include <string>

#include "description/scene.hpp"

namespace treeline {

/// Arguments beside q.
enum Inputs : unsigned { kQd = 1, kQdd = 2, kTau = 4, kXddCmd = 8, kForces = 16, kPosture = 32 };

/// What all routes of a function have in common.
struct Signature {
  std::string equation;
  unsigned inputs = 0;  ///< out of `Inputs`
};

/// Of functions that are not about contacts, objects, posture or derivatives; of those nothing.
Signature signature(Function function);

}  // namespace treeline
