#pragma once

#include "emission/emission_context.hpp"
#include "text/diagnostic.hpp"

namespace treeline::opencl {

/// Reports what a scene asks for and OpenCL C does not have.
void refuse(const EmissionContext& context, Diagnostics& diagnostics);

}  // namespace treeline::opencl
