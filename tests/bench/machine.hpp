#pragma once

#include <string>

namespace treeline::bench {

struct Machine {
  std::string processor;  ///< as the system names it
  std::string caches;     ///< "L1i 32, L1d 48, L2 1024, L3 32768 KiB"
  double gigahertz = 0;   ///< of this core now, from a chain of multiplications
};

/// Measures the clock for a few milliseconds; 0 where the latency of a multiplication is not known
/// to be three cycles.
Machine describe_machine();

}  // namespace treeline::bench
