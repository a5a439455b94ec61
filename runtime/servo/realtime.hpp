#pragma once

#include <string>

namespace treeline::servo {

/// Asks the operating system for what a steady period needs: memory locked, first-in-first-out
/// scheduling of the calling thread. What was refused, in words; empty when both were granted.
std::string request_realtime();

}  // namespace treeline::servo
