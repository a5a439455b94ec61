#pragma once

#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "program/program.hpp"

namespace treeline {

/// What the entries of a program's results, and the rounding errors of the emitted code, are at
/// most anywhere in a domain, against exact arithmetic on the same inputs and the same constants,
/// as printed. Sines and cosines of at most 1.0 ulp and every operation count; products and sums
/// may be contracted or not, so that one bound holds for all compilers and flags but -ffast-math.
struct RoundingBound {
  /// Why there is none; empty: there is one.
  std::string missing = "it was not computed";
  std::vector<double> size, error;  ///< of all results' entries, in order; absolute, SI units

  [[nodiscard]] bool exists() const { return missing.empty(); }
};

/// `unit` is 2^-53 for double, 2^-24 for float.
RoundingBound bound_rounding(const Program& program, const Domain& domain, double unit);

/// `2.9e-12 in tau (tau[0]; 21 ulp of 1.3e+03, the most that tau can be)` for each result, or why
/// there is no bound.
std::string describe(const RoundingBound& bound, const Program& program, double unit);

}  // namespace treeline
