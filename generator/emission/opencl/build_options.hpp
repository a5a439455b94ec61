#pragma once

namespace treeline::opencl {

/// What clBuildProgram is told, beside the folder.
inline constexpr const char* kBuildOptions = "-cl-std=CL1.2";
/// What it is told for numbers of float as well: by default their quotients may be 2.5 ulp off.
inline constexpr const char* kBuildOptionsOfFloat = "-cl-fp32-correctly-rounded-divide-sqrt";

}  // namespace treeline::opencl
