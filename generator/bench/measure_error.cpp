#include "bench/measure_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/judges.hpp"

namespace treeline {
namespace {

/// An entry below this share of the size of its terms counts as zero: no double tells it from 0.
/// Pivots of relaxed tasks leave such entries in 1 - Jbar J of an arm without a null space.
constexpr double kZero = 0x1p-53;

double share(double error, double whole) {
  if (error == 0) return 0;
  const double ratio = error / whole;
  return ratio <= std::numeric_limits<double>::max() ? ratio
                                                     : std::numeric_limits<double>::infinity();
}

bool is_zero(const FunctionReference& reference, std::size_t i) {
  return std::abs(reference.high[i]) <= kZero * reference.size[i];
}

}  // namespace

AnswerError measure_error(const std::vector<double>& actual, const FunctionReference& reference,
                          const std::vector<std::size_t>& ends) {
  AnswerError worst;
  std::size_t i = 0;
  for (const std::size_t end : ends) {
    double largest_error = 0;
    double largest_entry = 0;
    double largest_size = 0;
    for (; i < end; ++i) {
      const double difference = std::abs((reference.high[i] - actual[i]) + reference.low[i]);
      const double error =
          std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
      const bool zero = is_zero(reference, i);
      worst.component = std::max(
          worst.component, share(error, zero ? reference.size[i] : std::abs(reference.high[i])));
      largest_error = std::max(largest_error, error);
      largest_size = std::max(largest_size, reference.size[i]);
      if (!zero) largest_entry = std::max(largest_entry, std::abs(reference.high[i]));
    }
    worst.norm = std::max(worst.norm,
                          share(largest_error, largest_entry > 0 ? largest_entry : largest_size));
  }
  return worst;
}

ErrorSummary summarise_errors(std::vector<double> errors) {
  if (errors.empty()) return {};
  const double worst = *std::max_element(errors.begin(), errors.end());
  return {quantile(errors, 0.5), quantile(errors, 0.99), worst};
}

}  // namespace treeline
