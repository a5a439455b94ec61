#pragma once

#include "program/program.hpp"

namespace treeline {

/// Length in cycles of the longest chain of operations in which each waits for the previous one.
/// Latencies are those of current x86 cores (Fog, Instruction tables; Zen 3 to 5, Ice Lake): 3 for
/// an addition or a product, 13 for a division. Sines and cosines count nothing, because every
/// chain begins with them.
int critical_path(const Program& program);

}  // namespace treeline
