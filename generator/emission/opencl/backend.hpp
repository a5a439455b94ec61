#pragma once

#include "emission/backend.hpp"

namespace treeline::opencl {

/// OpenCL C 1.2: functions of C with a kernel each, which a driver compiles for its device when a
/// program runs.
Backend make_backend();

}  // namespace treeline::opencl
