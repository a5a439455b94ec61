#pragma once

#include "program/program.hpp"

namespace treeline {

/// Cycles that the longest chain of operations takes of which each waits for the last, with the
/// latencies of current x86 cores (Fog, Instruction tables; Zen 3 to 5, Ice Lake): 3 for an
/// addition or a product, 13 for a division. Sines and cosines are where all chains begin, and
/// count nothing.
int critical_path(const Program& program);

}  // namespace treeline
