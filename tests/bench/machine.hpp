#pragma once

#include <string>

#include "limits.hpp"

namespace treeline::bench {

struct Machine {
  std::string processor;  ///< as the system names it
  std::string caches;     ///< "L1i 32, L1d 48, L2 1024, L3 32768 KiB"
  Limits limits;          ///< of this core now
};

/// Describes this machine. Takes some tenths of a second.
Machine describe_machine();

}  // namespace treeline::bench
