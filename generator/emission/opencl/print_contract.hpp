#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::opencl {

/// The header NAME.h, for the device and the host's programs.
std::string print_contract(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::opencl
