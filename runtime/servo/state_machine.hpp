#pragma once

#include "core/mode.hpp"

namespace treeline::servo {

using core::Event;
using core::Mode;
using core::mode_name;
using core::next_mode;

}  // namespace treeline::servo
