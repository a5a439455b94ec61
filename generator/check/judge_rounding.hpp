#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bounds/domain.hpp"
#include "check/report.hpp"
#include "compilation/generated_library.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Inputs and outputs of one call of a function at a state.
struct Call {
  const State* state = nullptr;
  double condition = 1;  ///< condition number of the matrix that it solves with
  /// Size of each entry's terms. An error below their rounding says nothing about the code, because
  /// a first-order bound vanishes together with its value.
  std::span<const double> sizes;
  CallResult result;
};

/// Compares results with the stated rounding errors of `generated`. Errors are differences from the
/// graph in long double, whose own errors are negligible. A proven bound is compared in states of
/// `domain`. A first-order bound is propagated to every state and compared there, except where
/// second-order errors could matter. Returns nothing if no bound is known. `unit` is half an ulp of
/// one.
std::optional<RoundingReport> judge_rounding(const GeneratedFunction& generated,
                                             const Domain& domain, double unit,
                                             const std::vector<Call>& calls);

}  // namespace treeline
