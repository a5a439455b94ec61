#pragma once

#include <vector>

#include "recursion/routes/trace.hpp"

// Routes to functions of the task that solve with Lambda^-1, see `robot_routes`.

namespace treeline {

/// To Lambda^-1, or to Lambda if `invert`.
std::vector<Route> lambda_routes(const Tree<Expression>& tree, bool invert, TaskLaws& laws);

std::vector<Route> control_routes(const Mechanism& mechanism, const Tree<Expression>& tree,
                                  TaskLaws& laws);

/// To the dynamically consistent inverse Jbar, or to the projector 1 - Jbar J if `project`: by the
/// factors of M, which mimic joints permit.
std::vector<Route> consistent_inverse_routes(const Tree<Expression>& tree, bool project,
                                             TaskLaws& laws);

/// To the forces of gravity in the task rows, or to those of velocities.
std::vector<Route> operational_force_routes(const Tree<Expression>& tree, bool of_gravity,
                                            TaskLaws& laws);

}  // namespace treeline
