#pragma once

#include <vector>

#include "emission/limit_facts.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Limits of torques and friction as NAME_limited.hpp has them. `functions` include
/// constraint_jacobian where rows are held.
LimitFacts describe_limits(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                           const std::vector<GeneratedFunction>& functions);

}  // namespace treeline
