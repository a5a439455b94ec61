#pragma once

#include <string>
#include <vector>

#include "emission/emission_context.hpp"

namespace treeline {

/// Names of the sources that a program with the controller's step compiles.
std::vector<std::string> list_controller_sources(Language language, const ControllerUnit& unit);

/// Bytes that a step is estimated to keep on the stack: what it knows of the measured state, the
/// law's own numbers, and the values of the function that keeps most.
std::size_t count_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number);

/// Equations of the laws that the controller has, by command.
std::string describe_laws(const ControllerUnit& unit);

/// Operations of the functions that a step calls.
std::string describe_step_cost(const ControllerUnit& unit);

/// Joints and points with the numbers that commands call them by.
std::string list_joint_names(const ControllerUnit& unit);

/// Files that a program with the controller compiles.
std::string describe_files(const EmissionContext& context, const ControllerUnit& unit);

/// The stack of a step, and what measures it; see `count_step_stack`.
std::string describe_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number);

}  // namespace treeline
