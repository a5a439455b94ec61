#pragma once

#include <string>
#include <vector>

#include "case.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// Difference between two subjects' results of a function: the largest of all states, relative to
/// the largest entry of the result. NaN counts as infinite.
struct Difference {
  std::string implementation;
  Function function{};
  double worst = 0;
};

/// Compares every function of `subjects` with that of the first subject that has it. Calls for
/// several states take as many of `states` at once; a multiple of 16 is used completely.
std::vector<Difference> differences(const Case& robot, const std::vector<Subject>& subjects,
                                    const std::vector<State>& states);

/// Largest difference that counts as agreement. All results are computed in double by different
/// algorithms. 1e-8 is far above their rounding, even through the inverse of a Lambda^-1 of
/// condition 1e6 (an almost stretched leg), and far below any real difference.
inline constexpr double kAgreement = 1e-8;

}  // namespace treeline::bench
