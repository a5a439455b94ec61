#pragma once

#include <string>
#include <vector>

#include "emission/emission_context.hpp"

namespace treeline {

/// Names of the sources that a program with the controller's step compiles.
std::vector<std::string> list_controller_sources(const ControllerUnit& unit);

/// Bytes that a step is estimated to keep on the stack: what it knows of the measured state, the
/// law's own numbers, and the values of the function that keeps most.
std::size_t count_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number);

}  // namespace treeline
