#pragma once

#include <string>

namespace treeline::bench {

/// What one core can do at most, measured: the median of many short runs of streams without
/// dependences or memory. A cycle is a third of a dependent integer multiplication, which takes
/// three on every x86-64 core since 2008, timed in turn with each stream, so that a change of the
/// clock's rate is not taken for a limit. All zeros on other processors.
struct Limits {
  double gigahertz = 0;
  double mul_add = 0;     ///< flops a cycle: scalar products and sums, half each
  double scalar_fma = 0;  ///< flops a cycle: scalar fused products and sums
  double packed_fma = 0;  ///< the same, of registers as wide as -march=native has
  int lanes = 1;          ///< doubles in such a register
  double near_code = 0;   ///< bytes a cycle: straight-line code of 24 KiB, from the core's cache
  double far_code = 0;    ///< the same of 128 KiB: from the second level

  /// One line.
  [[nodiscard]] std::string text() const;
};

Limits measure_limits();

}  // namespace treeline::bench
