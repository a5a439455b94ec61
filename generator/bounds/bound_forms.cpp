#include "bounds/bound_forms.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "bounds/exact_operation.hpp"

namespace treeline::bounds {
namespace {

constexpr int kDeepest = 100;
constexpr std::size_t kMostTerms = 60, kMostRootTerms = 6;
constexpr double kFactorSlack = 0x1p-40;  // relative to the terms of a factor's sum
constexpr double kNothing = kFactorSlack / 16;

}  // namespace

FormBounds::FormBounds(const NodeBounds& known, NormMemo& norms, NormOf norm_of)
    : known_(known),
      norms_(norms),
      norm_of_(std::move(norm_of)),
      forms_(known),
      height_(known.graph.nodes().size()) {}

std::optional<Bounded> FormBounds::add(std::uint32_t node) {
  const Node& n = known_.graph.nodes()[node];
  const int operands = operation(n.op).operands;
  if (operands > 0) height_[node] = height_[n.a] + 1;
  if (operands > 1) height_[node] = std::max(height_[node], height_[n.b] + 1);
  forms_.add(node);
  if (n.op != Op::add && n.op != Op::sub) return std::nullopt;
  const QuadraticForm& form = forms_.of(node);
  bool has_turned = false, has_product = false;
  for (const FormTerm& term : form.terms) {
    if (!is_open(term.of)) continue;
    (term.of.is_linear() ? has_turned : has_product) = true;
  }
  if (!has_turned || !has_product || form.terms.size() > kMostRootTerms) return std::nullopt;
  const Bounded all = bound_root(form, 1), half = bound_root(form, 0.5);
  return Bounded{std::min(all.size, half.size), std::min(all.error, half.error)};
}

/// Bounds a form. Of each product with a turned value, the share `kept` is bounded together with
/// what is turned by the same angle; everything else is bounded alone.
Bounded FormBounds::bound_root(const QuadraticForm& form, double kept) {
  Row row;
  Bounded rest{0, form.error};
  for (const FormTerm& term : form.terms) {
    const bool open = is_open(term.of);
    const double share = !open ? 0 : term.of.is_linear() ? 1 : kept;
    const Bounded bound = bound_monomial(term.of);
    const double left = (1 - share) * std::abs(term.factor.c[0]) + kFactorSlack * term.summed;
    rest.size += left * bound.size;
    rest.error += left * bound.error;
    if (share != 0) row.push_back({term.of, share * term.factor.c[0]});
  }
  const Bounded together = bound_rows({std::move(row)}, 0);
  return {(together.size + rest.size) * kSlack, (together.error + rest.error) * kSlack};
}

Bounded FormBounds::bound_monomial(const Monomial& of) const {
  const Bounded b = *known_.bounds[of.b];
  if (of.is_linear()) return b;
  const Bounded a = *known_.bounds[of.a];
  return {a.size * b.size, a.size * b.error + b.size * a.error + known_.unit * a.error * b.error};
}

bool FormBounds::is_input(std::uint32_t node) const {
  return known_.graph.nodes()[node].op == Op::input;
}

/// Whether the monomial is a turned value, or a product with one and without an input. Inputs are
/// velocities of joints, whose products do not cancel.
bool FormBounds::is_open(const Monomial& of) const {
  if (of.is_linear()) return forms_.turn(of.b) != 0;
  return (forms_.turn(of.a) != 0 || forms_.turn(of.b) != 0) && !is_input(of.a) && !is_input(of.b);
}

Bounded FormBounds::bound_alone(const Rows& rows) const {
  Bounded bound;
  for (const Row& row : rows) {
    Bounded sum;
    for (const Coefficient& term : row) {
      const Bounded monomial = bound_monomial(term.of);
      sum.size += std::abs(term.factor) * monomial.size;
      sum.error += std::abs(term.factor) * monomial.error;
    }
    bound = {std::hypot(bound.size, sum.size), std::hypot(bound.error, sum.error)};
  }
  return {bound.size * kSlack, bound.error * kSlack};
}

Bounded FormBounds::bound_rows(Rows rows, int depth) {
  std::sort(rows.begin(), rows.end());
  std::vector<std::uint64_t> key;
  for (const Row& row : rows) {
    key.push_back(row.size());
    for (const Coefficient& term : row) {
      key.insert(key.end(), {std::uint64_t{term.of.a} << 32 | term.of.b,
                             std::bit_cast<std::uint64_t>(term.factor)});
    }
  }
  if (const Bounded* const found = bounds_.find(key)) return *found;
  Bounded bound = bound_alone(rows);
  if (depth < kDeepest) {
    if (const auto turned = turn_rows(rows, depth)) {
      bound = {std::min(bound.size, turned->size), std::min(bound.error, turned->error)};
    }
  }
  return bounds_.add(key, bound);
}

/// Returns the angle that turns the value closest to the results, or 0 if none is turned.
Angle FormBounds::nearest_turn(const Rows& rows) const {
  int highest = -1;
  Angle angle = 0;
  for (const Row& row : rows) {
    for (const Coefficient& term : row) {
      for (const std::uint32_t node : {term.of.a, term.of.b}) {
        if (forms_.turn(node) == 0 || height_[node] <= highest) continue;
        highest = height_[node];
        angle = forms_.turn(node);
      }
    }
  }
  return angle;
}

const QuadraticForm* FormBounds::turned(std::uint32_t node, bool linear) {
  const auto [at, is_new] = turned_.try_emplace({node, linear});
  if (is_new) at->second = forms_.turned(node, linear);
  return at->second ? &*at->second : nullptr;
}

bool FormBounds::substitute(const Coefficient& term, Angle angle, QuadraticForm& form) {
  if (!term.of.is_linear()) return substitute_product(term, angle, form);
  const double size = std::abs(term.factor);
  if (forms_.turn(term.of.b) != angle) {
    form.terms.push_back({term.of, constant(term.factor), size});
    return true;
  }
  const QuadraticForm* by = turned(term.of.b, false);
  if (by == nullptr) return false;
  for (FormTerm each : by->terms) {
    for (double& x : each.factor.c) x *= term.factor;
    each.summed *= size;
    form.terms.push_back(each);
  }
  form.error += size * by->error;
  return true;
}

/// Substitutes the forms of a and b in the term k a b.
bool FormBounds::substitute_product(const Coefficient& term, Angle angle, QuadraticForm& form) {
  const auto factor = [&](std::uint32_t node, QuadraticForm& own) -> const QuadraticForm* {
    if (forms_.turn(node) == angle) return turned(node, true);
    own.terms.push_back({{0, node}, constant(1), 1});
    return &own;
  };
  QuadraticForm own_a, own_b;
  const QuadraticForm *a = factor(term.of.a, own_a), *b = factor(term.of.b, own_b);
  if (a == nullptr || b == nullptr) return false;
  const double size = std::abs(term.factor);
  for (const FormTerm& p : a->terms) {
    for (const FormTerm& q : b->terms) {
      auto both = multiply(p.factor, q.factor);
      if (!both) return false;
      for (double& x : both->c) x *= term.factor;
      form.terms.push_back({product(p.of.b, q.of.b), *both, size * p.summed * q.summed});
    }
  }
  form.error += size * (a->error * known_.computed(term.of.b) +
                        b->error * (known_.computed(term.of.a) + known_.unit * a->error));
  return true;
}

std::optional<QuadraticForm> FormBounds::substitute(const Row& row, Angle angle) {
  QuadraticForm form;
  for (const Coefficient& term : row) {
    if (!substitute(term, angle, form)) return std::nullopt;
  }
  collect_terms(form.terms);
  if (form.terms.size() > kMostTerms) return std::nullopt;
  return form;
}

/// Rows, written as the matrix A of sines and cosines of one angle times `columns`, the rows that
/// remain to be bounded.
class FormBounds::Turn {
 public:
  explicit Turn(std::size_t rows) { A.rows = rows; }

  /// Adds the terms of the current row that remain to be bounded.
  void add_open(const std::vector<FormTerm>& terms) {
    std::array<Row, 5> parts;
    for (const FormTerm& term : terms) {
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const double factor = term.factor.c[i];
        if (std::abs(factor) > kNothing * term.summed) {  // smaller ones are within the slack
          parts[i].push_back({term.of, factor});
        }
      }
    }
    for (std::size_t i = 0; i < parts.size(); ++i) add_part(i, std::move(parts[i]));
  }
  /// Adds a term of the current row that is bounded as it is: `factor` times the values `node` and
  /// `other`. Terms are grouped in one matrix for each `node`.
  void add_closed(std::uint32_t node, std::uint32_t other, const TrigPolynomial& factor) {
    Closed& some = closed[node];
    const auto found = std::find(some.others.begin(), some.others.end(), other);
    const auto column = static_cast<std::size_t>(found - some.others.begin());
    if (found == some.others.end()) some.others.push_back(other);
    some.A.entries.push_back({row_, column, factor});
    some.A.rows = A.rows;
    some.A.columns = some.others.size();
  }
  void end_row(const Bounded& slack) {
    rest = {std::hypot(rest.size, slack.size), std::hypot(rest.error, slack.error)};
    ++row_;
  }

  struct Closed {
    std::vector<std::uint32_t> others;
    TrigMatrix A;
  };
  Rows columns;
  TrigMatrix A;
  std::map<std::uint32_t, Closed> closed;  ///< by node; 0: terms without such a factor
  Bounded rest;                            ///< from rounding

 private:
  /// Adds what the constant, the cosine or the sine multiplies: one of the columns or a multiple of
  /// one.
  void add_part(std::size_t basis, Row part) {
    double largest = 0;
    for (const Coefficient& term : part) {
      if (std::abs(term.factor) > std::abs(largest)) largest = term.factor;
    }
    if (largest == 0) return;
    for (Coefficient& term : part) term.factor /= largest;
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [&](const Row& other) { return are_same(other, part); });
    MatrixEntry entry{row_, static_cast<std::size_t>(found - columns.begin()), {}};
    entry.value.angle = 1;
    entry.value.c[basis] = largest;
    A.entries.push_back(entry);
    if (found == columns.end()) columns.push_back(std::move(part));
    A.columns = columns.size();
  }

  /// Whether two rows are equal within the slack of factors, which is part of `rest`.
  static bool are_same(const Row& x, const Row& y) {
    return std::equal(
        x.begin(), x.end(), y.begin(), y.end(), [](const Coefficient& p, const Coefficient& q) {
          return p.of == q.of &&
                 std::abs(p.factor - q.factor) <= kFactorSlack / 4 * std::abs(p.factor);
        });
  }

  std::size_t row_ = 0;
};

/// Bounds what is not turned: the rounding, and for each node its size times the norm of what it
/// multiplies. Nothing if a matrix is too large.
std::optional<Bounded> FormBounds::bound_rest(const Turn& turn) const {
  Bounded rest = turn.rest;
  for (const auto& [factor, closed] : turn.closed) {
    if (closed.others.size() > kMostRows) return std::nullopt;
    const auto& [scale, norm] = norms_.of(closed.A);
    Set others;
    for (std::size_t i = 0; i < scale.size(); ++i) others.push_back({closed.others[i], scale[i]});
    const Bounded by = factor == 0 ? Bounded{1, 0} : *known_.bounds[factor];
    const Bounded of = norm_of_(others);
    rest.size += norm * by.size * of.size;
    rest.error +=
        norm * (by.size * of.error + by.error * of.size + known_.unit * by.error * of.error);
  }
  return Bounded{rest.size * kSlack, rest.error * kSlack};
}

std::optional<Bounded> FormBounds::turn_rows(const Rows& rows, int depth) {
  const Angle angle = nearest_turn(rows);
  if (angle == 0) return std::nullopt;
  Turn turn(rows.size());
  for (const Row& row : rows) {
    const auto form = substitute(row, angle);
    if (!form) return std::nullopt;
    Bounded slack{0, form->error};
    std::vector<FormTerm> open;
    for (const FormTerm& term : form->terms) {
      const Bounded bound = bound_monomial(term.of);
      slack.size += kFactorSlack * term.summed * bound.size;
      slack.error += kFactorSlack * term.summed * bound.error;
      if (is_open(term.of)) {
        open.push_back(term);
      } else if (term.factor.magnitude() > kNothing * term.summed) {
        const bool last = term.of.a != 0 && is_input(term.of.b);
        turn.add_closed(last ? term.of.b : term.of.a, last ? term.of.a : term.of.b, term.factor);
      }
    }
    turn.add_open(open);
    turn.end_row(slack);
  }
  if (turn.columns.size() > kMostRows) return std::nullopt;
  const auto rest = bound_rest(turn);
  if (!rest || turn.columns.empty()) return rest;
  const auto& [scale, norm] = norms_.of(turn.A);
  for (std::size_t i = 0; i < turn.columns.size(); ++i) {
    for (Coefficient& term : turn.columns[i]) term.factor *= scale[i];
  }
  const Bounded below = bound_rows(std::move(turn.columns), depth + 1);
  return Bounded{(norm * below.size + rest->size) * kSlack,
                 (norm * below.error + rest->error) * kSlack};
}

}  // namespace treeline::bounds
