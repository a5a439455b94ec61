#pragma once

#include <cstddef>
#include <vector>

#include "oracle/reference.hpp"

namespace treeline {

/// Relative errors of one call: 1e-16 is about the last digit of a double.
struct AnswerError {
  /// Norm-wise error: the largest error of an entry of a result relative to the result's largest
  /// entry. The worst result counts.
  double norm = 0;
  /// Component-wise error: the largest relative error of any entry.
  double component = 0;
};

/// Compares a result with its reference. `ends` has the end of each result among the entries; what
/// comes after the last is not compared. If the reference of an entry is zero, up to what 50 digits
/// leave of zero, its error is relative to the size of its terms. The errors are infinite if an
/// entry is not finite.
AnswerError measure_error(const std::vector<double>& actual, const FunctionReference& reference,
                          const std::vector<std::size_t>& ends);

/// Summary of errors at many states.
struct ErrorSummary {
  double median = 0, percent_99 = 0, worst = 0;
};
ErrorSummary summarise_errors(std::vector<double> errors);

}  // namespace treeline
