#pragma once

#include <optional>
#include <vector>

#include "bounds/domain.hpp"
#include "check/generated_library.hpp"
#include "check/reference.hpp"
#include "check/report.hpp"

namespace treeline {

/// What a function left at a state.
struct Call {
  const State* state = nullptr;
  double condition = 1;  ///< of what it solves with there
  CallResult result;
};

/// Holds results to what is known of the rounding errors of `generated`, both against the graph in
/// long double, whose own errors are of no account: a proven bound in states of `domain`; one of
/// first order at every state, by propagation there, but where errors of second order could count.
/// Nothing where no bound is known. `unit` is half an ulp of one.
std::optional<RoundingReport> judge_rounding(const GeneratedFunction& generated,
                                             const Domain& domain, double unit,
                                             const std::vector<Call>& calls);

}  // namespace treeline
