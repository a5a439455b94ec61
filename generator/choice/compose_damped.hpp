#pragma once

#include <vector>

#include "choice/generated_function.hpp"

namespace treeline {

/// Makes `damped_control_torque` callable like other functions. It has the arguments and results of
/// NAME_damped.hpp; its return value, the smallest eigenvalue of the scaled Lambda^-1, is the last
/// result. Its program has no graph: it is composed of loops and of `functions`, which must include
/// `kDampedFunctions`.
GeneratedFunction compose_damped(const std::vector<GeneratedFunction>& functions);

}  // namespace treeline
