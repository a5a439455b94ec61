#include "bounds/turn_rounding.hpp"

#include <cmath>

namespace treeline::bounds {

TurnRounding::TurnRounding(std::size_t rows, std::size_t columns)
    : columns_(columns), products_{rows, columns, {}}, taken_(rows * columns) {}

bool TurnRounding::add(std::size_t row, std::size_t column, const TrigPolynomial& t, double weight,
                       double sine_error) {
  if (taken_[row * columns_ + column]) return false;
  taken_[row * columns_ + column] = true;
  MatrixEntry entry{row, column, t};
  for (double& x : entry.value.c) x *= weight;
  products_.entries.push_back(entry);
  sine_errors_.push_back(weight * sine_error);
  return true;
}

double TurnRounding::bound(const std::vector<double>& scale, double computed, double unit) const {
  if (products_.entries.empty()) return 0;
  double sines = 0;
  for (std::size_t i = 0; i < sine_errors_.size(); ++i) {
    sines = std::hypot(sines, sine_errors_[i] / scale[products_.entries[i].column]);
  }
  // Computed sines |t| + u e_t and rounded products are both less than 1 + 2u times as large.
  return (frobenius_norm(products_, scale) + sines) * computed * (1 + 4 * unit);
}

}  // namespace treeline::bounds
