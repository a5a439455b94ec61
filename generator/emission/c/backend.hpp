#pragma once

#include "emission/backend.hpp"

namespace treeline::c {

/// C99, freestanding: the robot's name before every name that others see, arrays by pointers with
/// their sizes, lanes as vectors of GCC and Clang.
Backend make_backend();

}  // namespace treeline::c
