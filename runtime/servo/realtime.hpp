#pragma once

#include <string>

namespace treeline::servo {

/// Asks the operating system for what steady periods need: locked memory, first-in-first-out
/// scheduling of the calling thread, and, with that and more than one core, the last core that it
/// may run on for it alone: all other threads of the process, and those that they start, keep to
/// the other cores. Returns a text about what was refused; empty if all was granted.
std::string request_realtime();

/// Asks Linux to run the calling thread before others of its kind: nice -10. For threads that pass
/// messages on, so that neither they nor a lock that they hold waits behind other work. Returns
/// whether that was granted; without it they are only slower on a machine that is busy.
bool request_attention();

}  // namespace treeline::servo
