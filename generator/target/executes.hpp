#pragma once

#include "target/target.hpp"

namespace treeline {

/// Whether this machine executes code that is compiled with the flags of a target of x86. False for
/// all other targets.
bool executes(const Target& target);

}  // namespace treeline
