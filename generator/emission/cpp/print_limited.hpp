#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// `NAME_limited.hpp`: `limited_control_torque`, composed of others of the functions. `context` has
/// limits. Throws std::logic_error where a function is not among `programs`.
std::string print_limited(const EmissionContext& context, std::span<const Program> programs);

/// `NAME_batch_limited.hpp`: the same for several states, composed of functions of a batch.
std::string print_batch_limited(const EmissionContext& context, std::span<const Program> batch);

}  // namespace treeline::cpp
