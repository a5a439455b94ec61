#pragma once

#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::opencl {

/// The source file that defines the program's function, as C has it, and the kernel that calls it.
std::string print_source(const EmissionContext& context, const Program& program);

}  // namespace treeline::opencl
