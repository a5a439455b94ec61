#pragma once

namespace treeline {

/// Time of operations in units of one sum's, for the choice among algorithms. Of generic code,
/// unless a target's are named.
///
/// A division occupies the divider for about four cycles on current cores, in each of which two
/// sums start; an angle costs about as much as its share of a polynomial that four lanes evaluate
/// together. Recursions along a chain wait for their operands most of the time. These weights are
/// fitted to 234 timed candidates (samm, anymal, humanoid24; g++ 12 and clang 14, Zen 5): the
/// candidate that they pick takes 1.2 % longer than the fastest one on average. Without the longest
/// chain, and with one half in place of two thirds of what lanes share, it took 10 % longer, and up
/// to 57 %.
struct OperationCosts {
  double product = 1;
  double quotient = 8;
  double angle = 12;   ///< its sine and cosine
  double waiting = 1;  ///< of each cycle of the longest chain; part is filled by other operations
  int lanes = 4;       ///< numbers of a register: doubles of AVX2, the widest to be relied on
  const char* source = "fitted to timed code on x86-64";  ///< of these numbers
};

}  // namespace treeline
