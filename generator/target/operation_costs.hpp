#pragma once

namespace treeline {

/// Time of operations in units of one sum's, for the choice among algorithms. Of generic code,
/// unless a target's are named.
///
/// A division occupies the divider for about four cycles on current cores, in each of which two
/// sums start; an angle costs about as much as its share of a polynomial that four lanes evaluate
/// together. A cycle in which a chain waits is two sums' time, but other operations fill it, see
/// `cost`. Of 308 timed candidates for 62 functions (chains and trees of 7 to 45 joints, ur10e,
/// PUMA, samm, humanoid24; 1 and 8 lanes; g++ 12 -O3 -march=native, Zen 5) the one that is picked
/// takes 1 % longer than the fastest on average, 6 % at most. It took 5 % longer, and up to 47 %,
/// when the chain was added to the operations, and 10 % and 60 % by the number of operations alone.
struct OperationCosts {
  double product = 1;
  double quotient = 8;
  double angle = 12;   ///< sine and cosine of one angle
  double waiting = 2;  ///< of each cycle of the longest chain
  int lanes = 4;       ///< numbers of a register: doubles of AVX2, the widest to be relied on
  const char* source = "fitted to timed code on x86-64";  ///< of these numbers
};

}  // namespace treeline
