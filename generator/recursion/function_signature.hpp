#pragma once

#include <string>

#include "description/scene.hpp"

namespace treeline {

/// Arguments of a function in addition to q, as bits.
enum Inputs : unsigned { kQd = 1, kQdd = 2, kTau = 4, kXddCmd = 8, kForces = 16, kPosture = 32 };

/// Properties that all routes of a function share.
struct Signature {
  std::string equation;
  unsigned inputs = 0;  ///< bits of `Inputs`
};

/// Signature of a function. Empty for functions about contacts, objects, posture or derivatives.
Signature signature(Function function);

}  // namespace treeline
