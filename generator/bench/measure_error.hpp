#pragma once

#include <cstddef>
#include <vector>

#include "oracle/reference.hpp"

namespace treeline {

/// How far one answer is from the truth, as shares: 1e-16 is about the last digit of a double.
struct AnswerError {
  /// The largest error of any entry of a result over its largest entry; of the worst result.
  double norm = 0;
  /// The largest share that any entry errs by.
  double component = 0;
};

/// `ends` says where each result ends among the entries. An entry whose truth is zero, or nothing
/// but what 50 digits leave of zero, is measured by the size of its terms. Infinite where an entry
/// is not finite.
AnswerError measure_error(const std::vector<double>& actual, const FunctionReference& reference,
                          const std::vector<std::size_t>& ends);

/// Of the errors at many states.
struct ErrorSummary {
  double median = 0, percent_99 = 0, worst = 0;
};
ErrorSummary summarise_errors(std::vector<double> errors);

}  // namespace treeline
