#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/syntax.hpp"
#include "program/program.hpp"

namespace treeline {

/// One of the functions that `damped_control_torque` calls, and where its result goes.
struct DampedCall {
  const Program* program = nullptr;
  std::string result;
};

/// In the order of the calls. Throws std::logic_error where one of `kDampedFunctions` is not among
/// `programs`.
std::vector<DampedCall> list_damped_calls(std::span<const Program> programs);

/// Name of an argument of one of these functions in `damped_control_torque`.
std::string damped_name(const Argument& argument);

/// Arguments of `damped_control_torque`, in the order of `control_torque`: q, its sines and
/// cosines, qd, qdd_0, xdd_cmd, f_ext, and what of the robot is an argument.
std::vector<Argument> list_damped_arguments(const std::vector<DampedCall>& calls, int task_rows);

/// Cost, stack and rounding, as every function of the contract states them.
std::string describe_damped_cost(const EmissionContext& context, std::span<const Program> programs);

/// The limits of effective mass with commas between.
std::string list_effective_mass_limits(const EmissionContext& context, const Syntax& syntax);

}  // namespace treeline
