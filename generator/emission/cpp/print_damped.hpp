#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// `NAME_damped.hpp`: `damped_control_torque`, composed of others of the functions. Throws
/// std::logic_error where one of `kDampedFunctions` is not among them.
std::string print_damped(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::cpp
