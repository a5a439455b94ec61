#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "bounds/norm_memo.hpp"
#include "bounds/quadratic_form.hpp"

namespace treeline::bounds {

/// Bounds differences in which products cancel. For instance, a link's angular acceleration may be
/// computed as the product of two angular velocities minus an entry of the parent's wd x + w x w x,
/// rotated. All that is left of those products is the velocity of the link's own joint times that
/// of the parent. To detect this, values are written as polynomials of second degree in the values
/// that were rotated last. The factors are sines and cosines of that angle, and the products cancel
/// in them. The norm of all polynomials of one angle is at most the 2-norm of the matrix of sines
/// and cosines times the norm of their coefficients. The coefficients are rotated by the next
/// angle, and so on down to the inputs.
class FormBounds {
 public:
  using NormOf = std::function<Bounded(const Set&)>;

  FormBounds(const NodeBounds& known, NormMemo& norms, NormOf norm_of);

  /// Returns a better bound of the node, if one is found. Call this for each node in order, once it
  /// has a bound.
  std::optional<Bounded> add(std::uint32_t node);

 private:
  /// A monomial with a constant factor.
  struct Coefficient {
    Monomial of;
    double factor = 0;
    auto operator<=>(const Coefficient&) const = default;
  };
  using Row = std::vector<Coefficient>;
  using Rows = std::vector<Row>;
  class Turn;

  [[nodiscard]] Bounded bound_monomial(const Monomial& of) const;
  [[nodiscard]] bool is_input(std::uint32_t node) const;
  [[nodiscard]] bool is_open(const Monomial& of) const;
  [[nodiscard]] Bounded bound_alone(const Rows& rows) const;
  [[nodiscard]] Bounded bound_root(const QuadraticForm& form, double kept);
  Bounded bound_rows(Rows rows, int depth);
  [[nodiscard]] Angle nearest_turn(const Rows& rows) const;
  std::optional<Bounded> turn_rows(const Rows& rows, int depth);
  std::optional<QuadraticForm> substitute(const Row& row, Angle angle);
  [[nodiscard]] std::optional<Bounded> bound_rest(const Turn& turn) const;
  const QuadraticForm* turned(std::uint32_t node, bool linear);
  bool substitute(const Coefficient& term, Angle angle, QuadraticForm& form);
  bool substitute_product(const Coefficient& term, Angle angle, QuadraticForm& form);

  const NodeBounds& known_;
  NormMemo& norms_;
  NormOf norm_of_;
  QuadraticForms forms_;
  std::vector<int> height_;  ///< number of operations on the longest path to an input
  std::map<std::pair<std::uint32_t, bool>, std::optional<QuadraticForm>> turned_;
  WordMemo<Bounded> bounds_;  ///< by rows
};

}  // namespace treeline::bounds
