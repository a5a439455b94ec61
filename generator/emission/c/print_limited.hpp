#pragma once

#include <span>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// NAME_limited.h and limited_control_torque.c, composed of others of the functions. `context` has
/// `limits`. Throws std::logic_error where a function that is called is missing.
std::vector<GeneratedFile> print_limited(const EmissionContext& context,
                                         std::span<const Program> programs);

/// The headers of the quadratic program, in the number type and the sizes of the robot. They
/// include square_root.h.
std::vector<GeneratedFile> print_limited_runtime(const EmissionContext& context);

}  // namespace treeline::c
