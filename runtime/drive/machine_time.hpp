#pragma once

#include <chrono>

namespace treeline::drive {

/// Time of the machine's steady clock, s.
inline double machine_time() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace treeline::drive
