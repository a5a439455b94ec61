#pragma once

#include <string>

namespace treeline::servo {

/// Asks the operating system for what steady periods need: locked memory, and first-in-first-out
/// scheduling of the calling thread. Returns a text about what was refused; empty if both were
/// granted.
std::string request_realtime();

}  // namespace treeline::servo
