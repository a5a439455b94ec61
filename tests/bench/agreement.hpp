#pragma once

#include <string>
#include <vector>

#include "case.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// How far one subject's function is from another's: the worst of all states, relative to the
/// largest entry of the result. NaN counts as infinite.
struct Difference {
  std::string implementation;
  Function function{};
  double worst = 0;
};

/// Compares every function of `subjects` with that of the first subject that has it. As many of
/// `states` as the calls take: a multiple of 16 are taken whole.
std::vector<Difference> differences(const Case& robot, const std::vector<Subject>& subjects,
                                    const std::vector<State>& states);

/// All that is compared is computed in double by different algorithms: 1e-8 is far above their
/// rounding, even through the inverse of a Lambda^-1 of condition 1e6 (a leg nearly stretched), and
/// far below any difference in what is computed.
inline constexpr double kAgreement = 1e-8;

}  // namespace treeline::bench
