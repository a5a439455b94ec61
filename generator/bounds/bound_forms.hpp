#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "bounds/norm_memo.hpp"
#include "bounds/quadratic_form.hpp"

namespace treeline::bounds {

/// Bounds differences whose products cancel. A link's angular acceleration may be computed as what
/// the product of two angular velocities has over an entry of the parent's wd x + w x w x, turned:
/// of all those products only the velocity of the link's own joint times the parent's is left. To
/// see that, values are written as polynomials of second degree in what is turned last, whose
/// factors are sines and cosines of that angle; in these the products cancel. The norm of the
/// polynomials of one angle is at most the 2-norm of the matrix of sines and cosines times the norm
/// of their coefficients, which are turned by the next angle, and so on to the sources.
class FormBounds {
 public:
  using NormOf = std::function<Bounded(const Set&)>;

  FormBounds(const NodeBounds& known, NormMemo& norms, NormOf norm_of);

  /// To be called for each node in order, once it has a bound: a better one, if there is one.
  std::optional<Bounded> add(std::uint32_t node);

 private:
  /// Constant factors of monomials.
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
  std::vector<int> height_;  ///< operations on the longest way to an input
  std::map<std::pair<std::uint32_t, bool>, std::optional<QuadraticForm>> turned_;
  std::map<Rows, Bounded> bounds_;
};

}  // namespace treeline::bounds
