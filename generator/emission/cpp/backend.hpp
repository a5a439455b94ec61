#pragma once

#include "emission/backend.hpp"

namespace treeline::cpp {

/// C++17: functions in a namespace, arrays by reference, lanes and batches by the headers of
/// runtime/core.
Backend make_backend();

}  // namespace treeline::cpp
