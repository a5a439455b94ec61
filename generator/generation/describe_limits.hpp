#pragma once

#include <vector>

#include "emission/limit_facts.hpp"
#include "generation/generate_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Limits of torques and friction as NAME_limited.hpp has them. `functions` include
/// constraint_jacobian where rows are held.
LimitFacts describe_limits(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                           const std::vector<GeneratedFunction>& functions);

/// Reports what limits cannot be kept with: constraints with friction along whose normal nothing
/// can move, as of a wheel under a base that keeps its height, whose normal force would be whatever
/// suits the limits; and rows that depend on each other beside constraints that come and go.
void check_held_rows(const Scene& scene, const Mechanism& mechanism,
                     const std::vector<GeneratedFunction>& functions, Diagnostics& diagnostics);

}  // namespace treeline
