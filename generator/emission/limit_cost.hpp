#pragma once

#include "emission/limit_facts.hpp"

namespace treeline {

/// The quadratic program of `limited_control_torque`.
struct LimitCost {
  int unknowns = 0;    ///< with the slack, padded to eights
  int rows = 0;        ///< of motors and cones
  int iterations = 0;  ///< most of a call
  long flops_of_iteration = 0;
  int values = 0;  ///< numbers on the stack beside those of the functions that are called
};

/// Computes the cost of limited control for a robot with `velocities` velocities.
LimitCost cost_of_limits(const LimitFacts& facts, int velocities);

}  // namespace treeline
