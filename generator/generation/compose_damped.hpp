#pragma once

#include <vector>

#include "generation/generate_code.hpp"

namespace treeline {

/// `damped_control_torque` as it can be called: arguments and results of NAME_damped.hpp, the least
/// ease, which it returns, as the last result. Its program has no graph: it is composed of
/// `functions`, which `kDampedFunctions` are among, and of loops.
GeneratedFunction compose_damped(const std::vector<GeneratedFunction>& functions);

}  // namespace treeline
