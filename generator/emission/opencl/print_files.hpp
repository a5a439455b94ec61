#pragma once

#include <span>
#include <string>

#include "emission/backend.hpp"
#include "emission/emission_context.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline::opencl {

/// The header NAME.h, for the device and the host's programs.
std::string print_contract(const EmissionContext& context, std::span<const Program> programs);

/// The source file that defines the program's function, as C has it, and the kernel that calls it.
std::string print_source(const EmissionContext& context, const Program& program);

/// Reports what a scene asks for and OpenCL C does not have.
void refuse(const EmissionContext& context, Diagnostics& diagnostics);

/// OpenCL C 1.2: functions of C with a kernel each, which a driver compiles for its device when a
/// program runs.
Backend make_backend();

/// What clBuildProgram is told, beside the folder.
inline constexpr const char* kBuildOptions = "-cl-std=CL1.2";
/// What it is told for numbers of float as well: by default their quotients may be 2.5 ulp off.
inline constexpr const char* kBuildOptionsOfFloat = "-cl-fp32-correctly-rounded-divide-sqrt";

}  // namespace treeline::opencl
