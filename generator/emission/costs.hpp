#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "emission/limit_facts.hpp"
#include "program/program.hpp"

namespace treeline {

/// What `damped_control_torque` costs: the functions that it calls and `core::damped_solve`, whose
/// sweeps take the same operations for every matrix.
struct DampedCost {
  OperationCount count;
  int square_roots = 0;
  int values = 0;  ///< live at once: arrays, and what the dearest of the functions needs
};

/// `core::add_damped_task_torque` alone, of a task with `rows` rows and a robot with `velocities`,
/// in float or double.
DampedCost cost_of_damped_solve(int rows, int velocities, bool single_precision);

/// With the functions, which are among `programs`.
DampedCost cost_of_damped(const EmissionContext& context, std::span<const Program> programs);

/// The names of the functions that it calls.
bool is_called_by_damped(const std::string& function);

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

/// How many numbers the emitted function is estimated to keep on the stack, beside the sines and
/// cosines: of straight lines those that are alive at once when the nodes are computed in their
/// order, and with `misra` those that its parts share; of loops over links their work space.
std::size_t count_stack_values(const Program& program, bool misra);

}  // namespace treeline
