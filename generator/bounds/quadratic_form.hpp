#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "bounds/node_bounds.hpp"

namespace treeline::bounds {

/// Product of the values of two nodes, a <= b. If a is node 0, the value of b alone.
struct Monomial {
  std::uint32_t a = 0, b = 0;
  auto operator<=>(const Monomial&) const = default;
  [[nodiscard]] bool is_linear() const { return a == 0; }
};
inline Monomial product(std::uint32_t x, std::uint32_t y) {
  return x < y ? Monomial{x, y} : Monomial{y, x};
}

/// A monomial times `factor`. `summed` is the sum of the magnitudes from which the factor was
/// summed up; the rounding of the factor is less than 1e-13 of it.
struct FormTerm {
  Monomial of;
  TrigPolynomial factor;
  double summed = 0;
};

/// Value of a node as a polynomial of the computed values of other nodes. `error` has what this
/// leaves out, in rounding units: the rounding of the operations that were expanded.
struct QuadraticForm {
  std::vector<FormTerm> terms;
  double error = 0;

  [[nodiscard]] bool is_linear() const;
};

/// Merges terms of the same monomial.
void collect_terms(std::vector<FormTerm>& terms);

/// Writes nodes as polynomials of second degree in values that are turned by one angle. The sums
/// that form such values stay as they are. Other sums and products are expanded.
class QuadraticForms {
 public:
  explicit QuadraticForms(const NodeBounds& known);

  /// Adds the form of a node. Call this for each node in order, once it has a bound.
  void add(std::uint32_t node);
  [[nodiscard]] const QuadraticForm& of(std::uint32_t node) const { return forms_[node]; }
  /// Angle that turns all terms of the node; 0 if there is none.
  [[nodiscard]] Angle turn(std::uint32_t node) const { return turns_[node]; }
  /// Expresses a turned node by sines and cosines of its angle times the values that are turned.
  /// With `linear` the form must be of first degree. Nothing if there is no such form.
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
