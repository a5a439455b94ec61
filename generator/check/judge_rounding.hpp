#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bounds/domain.hpp"
#include "check/generated_library.hpp"
#include "check/report.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// What a function left at a state.
struct Call {
  const State* state = nullptr;
  double condition = 1;  ///< of what it solves with there
  /// Of each entry's terms. An error below a rounding of these says nothing of the code: a bound of
  /// first order vanishes with what it is the bound of.
  std::span<const double> sizes;
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
