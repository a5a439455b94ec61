#pragma once

#include <vector>

#include "bounds/operator_norm.hpp"

namespace treeline::bounds {

/// Bounds what rounding adds to the norm of the rows of a turn, whose products are t a_j with the
/// sines and cosines t: u |t| |a_j| for the product, u e_t |a_j| for the error e_t of t. By
/// Cauchy-Schwarz this is at most the Frobenius norms of the matrices of t and of e_t, times the
/// norm of the a_j. These norms are sqrt 2 and 2 for a rotation, whereas each product alone would
/// count as much as the whole vector.
class TurnRounding {
 public:
  TurnRounding(std::size_t rows, std::size_t columns);

  /// Adds a product in this row with the value of this column. Returns false if there is one
  /// already.
  bool add(std::size_t row, std::size_t column, const TrigPolynomial& t, double weight,
           double sine_error);
  /// Bound in rounding units. `computed` is an upper bound of the norm of the computed values times
  /// `scale`.
  [[nodiscard]] double bound(const std::vector<double>& scale, double computed, double unit) const;

 private:
  std::size_t columns_;
  TrigMatrix products_;
  std::vector<double> sine_errors_;  ///< by entry
  std::vector<bool> taken_;
};

}  // namespace treeline::bounds
