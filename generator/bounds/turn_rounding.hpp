#pragma once

#include <vector>

#include "bounds/operator_norm.hpp"

namespace treeline::bounds {

/// What rounding the products t a_j of a turn, with the sines and cosines t, adds to the norm of
/// its rows: u |t| |a_j| for the product, u e_t |a_j| for the error of t. By Cauchy and Schwarz
/// that is at most the Frobenius norms of the matrices of t and of e_t times the norm of the a_j:
/// sqrt 2 and 2 for a rotation, where each product by itself counts as much as all of the vector.
class TurnRounding {
 public:
  TurnRounding(std::size_t rows, std::size_t columns);

  /// A product in this row with the value of this column. False where there is one already.
  bool add(std::size_t row, std::size_t column, const TrigPolynomial& t, double weight,
           double sine_error);
  /// In units of u; `computed` is the most that the norm of the computed values, times `scale`, is.
  [[nodiscard]] double bound(const std::vector<double>& scale, double computed, double unit) const;

 private:
  std::size_t columns_;
  TrigMatrix products_;
  std::vector<double> sine_errors_;  ///< of each entry
  std::vector<bool> taken_;
};

}  // namespace treeline::bounds
