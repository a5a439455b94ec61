#include "recursion/methods/ordinary_states.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace treeline {
namespace {

/// A row with less than this share of the largest diagonal entry, the square of 6e-14, does not
/// move: what is there comes from rounded products of the rotations above it.
constexpr double kRounding = 0x1p-88;

bool is_prime(int n) {
  for (int divisor = 2; divisor * divisor <= n; ++divisor) {
    if (n % divisor == 0) return false;
  }
  return n >= 2;
}

int prime_after(int n) {
  do ++n;
  while (!is_prime(n));
  return n;
}

/// Spread evenly over the limits, of angles over a turn at most: multiples of the square root of a
/// prime of its own. A rational one would leave a coordinate where it is in every state.
double ordinary_coordinate(const Coordinate& coordinate, int prime, int state) {
  const double reach = coordinate.ordinary_reach();
  const double low = std::clamp(coordinate.lower, -reach, reach);
  const double high = std::clamp(coordinate.upper, -reach, reach);
  const double multiple = (state + 0.5) * std::sqrt(static_cast<double>(prime));
  return low + (high - low) * (multiple - std::floor(multiple));
}

/// The nearest joint inward that has all six freedoms, or none.
int floating_above(const Tree<double>& tree, int link) {
  while (link >= 0 && !tree.links[static_cast<std::size_t>(link)].is_floating()) {
    link = tree.links[static_cast<std::size_t>(link)].parent;
  }
  return link;
}

}  // namespace

std::vector<double> ordinary_state(const Mechanism& mechanism, int state) {
  std::vector<double> q;
  int prime = 1;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    prime = prime_after(prime);
    q.push_back(turns_what_floats(mechanism.coordinates, coordinate)
                    ? coordinate.neutral()
                    : ordinary_coordinate(coordinate, prime, state));
  }
  return q;
}

std::size_t count_rows(const Tree<double>& tree) {
  std::size_t rows = 0;
  for (const auto& point : tree.operational_points) {
    rows += static_cast<std::size_t>(std::count(point.rows.begin(), point.rows.end(), true));
  }
  return rows;
}

double median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double rounded_border(double border) {
  return border > 0 && std::isfinite(border) ? std::exp2(std::round(std::log2(border))) : 0x1p-40;
}

double rounded_border(double ordinary, const BoundedInverseShape& shape) {
  return std::max(rounded_border(shape.share * ordinary), shape.least);
}

void OrdinaryPivots::add(const DenseMatrix<double>& A) {
  std::vector<double> diagonal;
  for (std::size_t k = 0; k < A.rows(); ++k) diagonal.push_back(A(k, k));
  add(A, diagonal);
}

void OrdinaryPivots::add(const DenseMatrix<double>& A, const std::vector<double>& diagonal) {
  pivots_.resize(A.rows());
  diagonals_.resize(A.rows());
  factor_ldlt(A, [&](std::size_t k, double c) {
    pivots_[k].push_back(c);
    diagonals_[k].push_back(diagonal[k]);
    return c > kDependent * diagonal[k] ? 1 / c : 0;
  });
}

bool OrdinaryPivots::is_dependent(std::size_t row) const {
  return !(median(pivots_[row]) > kDependent * diagonal(row));
}

bool OrdinaryPivots::has_dependent() const {
  for (std::size_t k = 0; k < rows(); ++k) {
    if (is_dependent(k)) return true;
  }
  return false;
}

std::vector<double> OrdinaryPivots::borders(const BoundedInverseShape& shape) const {
  double largest = 0;
  for (std::size_t k = 0; k < rows(); ++k) largest = std::max(largest, diagonal(k));
  std::vector<double> borders;
  for (std::size_t k = 0; k < rows(); ++k) {
    const bool moves = diagonal(k) > kRounding * largest;
    const double dependent = moves ? diagonal(k) : kDependent * largest;
    const bool yields = !moves || is_dependent(k);
    borders.push_back(rounded_border(yields ? dependent : median(pivots_[k]), shape));
  }
  return borders;
}

std::vector<bool> always_free(const Tree<double>& tree) {
  std::vector<bool> free;
  std::set<int> used;
  for (const auto& point : tree.operational_points) {
    const int joint = floating_above(tree, point.link);
    const bool first = joint >= 0 && used.insert(joint).second;
    free.insert(free.end(),
                static_cast<std::size_t>(std::count(point.rows.begin(), point.rows.end(), true)),
                first);
  }
  return free;
}

}  // namespace treeline
