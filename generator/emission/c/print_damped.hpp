#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// `double NAME_damped_control_torque(...)`: alike in header and source.
std::string print_damped_signature(const EmissionContext& context,
                                   std::span<const Program> programs);

/// NAME_damped.h.
GeneratedFile print_damped_header(const EmissionContext& context,
                                  std::span<const Program> programs);

/// NAME_damped.h and damped_control_torque.c, composed of others of the functions. Throws
/// std::logic_error where one of `kDampedFunctions` is not among them.
std::vector<GeneratedFile> print_damped(const Contents& contents);

}  // namespace treeline::c
