#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "bounds/node_bounds.hpp"

namespace treeline::bounds {

/// The product of two nodes' values, a <= b, or (a is node 0) the value of one.
struct Monomial {
  std::uint32_t a = 0, b = 0;
  auto operator<=>(const Monomial&) const = default;
  [[nodiscard]] bool is_linear() const { return a == 0; }
};
inline Monomial product(std::uint32_t x, std::uint32_t y) {
  return x < y ? Monomial{x, y} : Monomial{y, x};
}

/// `factor` times the monomial. `summed` is the sum of the magnitudes that the factor was added up
/// from: it is rounded by less than 1e-13 of that.
struct FormTerm {
  Monomial of;
  TrigPolynomial factor;
  double summed = 0;
};

/// A node's value as a polynomial of other nodes' computed values, but for `error`, in units of the
/// rounding unit: the roundings of the operations that were expanded.
struct QuadraticForm {
  std::vector<FormTerm> terms;
  double error = 0;

  [[nodiscard]] bool is_linear() const;
};

/// Terms of the same monomial become one.
void collect_terms(std::vector<FormTerm>& terms);

/// Writes nodes as polynomials of second degree, down to values that are turned by one angle: their
/// sums are left as they are, other sums and products are multiplied out.
class QuadraticForms {
 public:
  explicit QuadraticForms(const NodeBounds& known);

  /// To be called for each node in order, once it has a bound.
  void add(std::uint32_t node);
  [[nodiscard]] const QuadraticForm& of(std::uint32_t node) const { return forms_[node]; }
  /// The angle by which all terms of the node are turned; zero: there is none.
  [[nodiscard]] Angle turn(std::uint32_t node) const { return turns_[node]; }
  /// A node that is turned, by sines and cosines of its angle times what is turned. `linear`: of
  /// first degree. Nothing where that is not possible.
  [[nodiscard]] std::optional<QuadraticForm> turned(std::uint32_t node, bool linear) const;

 private:
  [[nodiscard]] Angle find_turn(const Node& node) const;
  [[nodiscard]] QuadraticForm expand(std::uint32_t node) const;
  [[nodiscard]] QuadraticForm sum(std::uint32_t node) const;
  [[nodiscard]] QuadraticForm product_of(std::uint32_t node) const;
  [[nodiscard]] QuadraticForm scaled(std::uint32_t node) const;

  const NodeBounds& known_;
  std::vector<QuadraticForm> forms_;
  std::vector<Angle> turns_;
};

}  // namespace treeline::bounds
