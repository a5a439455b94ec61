#pragma once

namespace treeline {

/// Bytes of code by `-Os`, for the choice between straight lines and loops over a table of links:
/// fitted to five functions of PUMA 560, iiwa14 and humanoid24 by g++ 12 with the flags of each
/// target. Straight lines of the arms, where the choice is close, come within 8 % of it, on x86-64
/// within 21 %, since there some are in lanes. Loops of all three robots come within 4 %, where
/// operations are emulated within 12 %.
struct CodeSizes {
  double operation = 0;  ///< of each operation in straight lines
  double start = 0;      ///< of a function of straight lines before: sines and cosines among them
  double loops = 0;      ///< of loops, relative to those in float on a Cortex-M4F
};

}  // namespace treeline
