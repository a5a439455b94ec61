#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
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

}  // namespace treeline
