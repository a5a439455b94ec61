#pragma once

#include <string>

namespace treeline::bench {

/// Measured limits of one core: medians of many short runs of instruction streams without
/// dependences or memory accesses. A cycle is a third of a dependent integer multiplication, which
/// takes three cycles on every x86-64 core since 2008. It is timed in turn with each stream, so
/// that a change of the clock rate does not affect the limits. All zeros on other processors.
struct Limits {
  double gigahertz = 0;
  double mul_add = 0;     ///< flops per cycle: scalar products and sums, half each
  double scalar_fma = 0;  ///< flops per cycle: scalar fused products and sums
  double packed_fma = 0;  ///< flops per cycle: fused, in registers of -march=native
  int lanes = 1;          ///< doubles per such register
  double near_code = 0;   ///< bytes per cycle: straight-line code of 24 KiB, in the core's cache
  double far_code = 0;    ///< bytes per cycle: straight-line code of 128 KiB, in the second level

  /// Prints the limits in one line.
  [[nodiscard]] std::string text() const;
};

Limits measure_limits();

}  // namespace treeline::bench
