#include "bounds/bound_sets.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "bounds/exact_operation.hpp"
#include "bounds/quaternion_scale.hpp"
#include "bounds/trig_polynomial.hpp"

namespace treeline::bounds {
namespace {

constexpr int kDeepestSets = 400;  // deepest nesting of sets
constexpr double kSineError = 1;   // at most 1.0 ulp of values below 1: core/sin_cos.hpp

/// Bound of a rounded result of this size. `brought` is the error that its operands bring.
Bounded rounded(double size, double brought, double unit) {
  return {size * kSlack, (brought + size + unit * brought) * kSlack};
}

}  // namespace

struct SetBounds::Turn {
  std::vector<LinearForm> forms;  ///< by row
  std::vector<std::uint32_t> leaves;
  TrigMatrix A;               ///< its rows have the weights of the set
  std::vector<Bounded> rest;  ///< by row, weighted: what is added to the turned part

  [[nodiscard]] std::size_t column(std::uint32_t leaf) const {
    return static_cast<std::size_t>(std::find(leaves.begin(), leaves.end(), leaf) - leaves.begin());
  }
};

SetBounds::SetBounds(const Graph& graph, InputSizes inputs, double unit)
    : graph_(graph),
      inputs_(std::move(inputs)),
      unit_(unit),
      polynomials_(find_polynomials(graph)),
      known_of_{graph, polynomials_, unit,
                std::vector<std::optional<Bounded>>(graph.nodes().size())},
      forms_(known_of_, norms_, [this](const Set& set) { return bound_set(set, 0); }),
      divisions_(graph.nodes().size()),
      height_(graph.nodes().size()),
      turns_(graph.nodes().size()) {
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) bound_node(i);
}

std::optional<Bounded> SetBounds::of(std::uint32_t node) const {
  return bounds_[node];
}

std::optional<std::uint32_t> SetBounds::division_below(std::uint32_t node) const {
  if (bounds_[node]) return std::nullopt;
  return divisions_[node];
}

void SetBounds::bound_node(std::uint32_t node) {
  const Node& n = graph_.nodes()[node];
  const int operands = operation(n.op).operands;
  for (int i = 0; i < operands; ++i) {
    const std::uint32_t operand = i == 0 ? n.a : n.b;
    height_[node] = std::max(height_[node], height_[operand] + 1);
    if (!bounds_[operand]) {
      divisions_[node] = divisions_[operand];
      return;
    }
  }
  if (n.op == Op::div) {
    if (is_quaternion_scale(graph_, node)) {
      bounds_[node] = Bounded{2 * kSlack, kQuaternionScaleError * kSlack};
    } else {
      divisions_[node] = node;
    }
    return;
  }
  bounds_[node] = bound_alone(node);
  if (polynomials_[node]) {
    bounds_[node]->size = std::min(bounds_[node]->size, polynomials_[node]->magnitude() * kSlack);
  } else {
    turns_[node] = find_turn(graph_, polynomials_, node);
    if (turns_[node] != 0) improve(node, bound_set({{node, 1}}, 0));
  }
  if (const auto better = forms_.add(node)) improve(node, *better);
}

void SetBounds::improve(std::uint32_t node, const Bounded& bound) {
  bounds_[node] = {std::min(bounds_[node]->size, bound.size),
                   std::min(bounds_[node]->error, bound.error)};
}

/// Bounds a node by the bounds of its operands alone.
Bounded SetBounds::bound_alone(std::uint32_t node) {
  const Node& n = graph_.nodes()[node];
  const auto operand = [this](std::uint32_t i) { return *bounds_[i]; };
  switch (n.op) {
    case Op::constant:  // printed exactly, except for float
      return {std::abs(n.value), unit_ > 0x1p-53 && !is_float(n.value) ? std::abs(n.value) : 0};
    case Op::input:
      return {inputs_[n.a], 0};
    case Op::neg:
      return operand(n.a);
    case Op::add:
    case Op::sub:
      return rounded(operand(n.a).size + operand(n.b).size, operand(n.a).error + operand(n.b).error,
                     unit_);
    case Op::mul: {
      const Bounded a = operand(n.a), b = operand(n.b);
      const double brought = a.size * b.error + b.size * a.error + unit_ * a.error * b.error;
      // |a b| <= (a^2 + b^2) / 2, and |a e_b + b e_a| is at most the product of both norms.
      if (turns_[n.a] != 0 && turns_[n.b] != 0 && n.a != n.b) {
        const Bounded pair = bound_set({{n.a, 1}, {n.b, 1}}, 0);
        return rounded(std::min(a.size * b.size, pair.size * pair.size / 2),
                       std::min(brought, pair.size * pair.error + unit_ * a.error * b.error),
                       unit_);
      }
      if (is_power_of_two(graph_.nodes()[n.a]) || is_power_of_two(graph_.nodes()[n.b])) {
        return {a.size * b.size, brought};
      }
      return rounded(a.size * b.size, brought, unit_);
    }
    case Op::sin:
    case Op::cos:
      return {1, operand(n.a).error + kSineError};
    case Op::div:
      break;
  }
  return {};
}

Bounded SetBounds::bound_members(const Set& set) const {
  double size = 0, error = 0;
  for (const Member& member : set) {
    size = std::hypot(size, member.weight * bounds_[member.node]->size);
    error = std::hypot(error, member.weight * bounds_[member.node]->error);
  }
  return {std::min(size, bound_polynomials(set)) * kSlack, error * kSlack};
}

/// Bounds the norm of a set of sines and cosines of one angle over all angles. Infinity if a member
/// is nothing of that kind.
double SetBounds::bound_polynomials(const Set& set) const {
  TrigMatrix A{set.size(), 1, {}};
  Angle angle = 0;
  for (std::size_t row = 0; row < set.size(); ++row) {
    const auto& polynomial = polynomials_[set[row].node];
    const bool fits =
        polynomial && (polynomial->is_constant() || angle == 0 || polynomial->angle == angle);
    if (!fits) return std::numeric_limits<double>::infinity();
    if (!polynomial->is_constant()) angle = polynomial->angle;
    MatrixEntry entry{row, 0, *polynomial};
    for (double& x : entry.value.c) x *= set[row].weight;
    A.entries.push_back(entry);
  }
  return operator_norm(A, {1});
}

/// Weights are scaled so that the largest is 1, and rounded, so that the same sets recur.
Bounded SetBounds::bound_set(Set set, int depth) {
  double largest = 0;
  for (const Member& member : set) largest = std::max(largest, member.weight);
  if (largest == 0) return {};
  for (Member& member : set) {
    member.weight = std::ceil(member.weight / largest * 0x1p30 - 0x1p-4) * 0x1p-30;
  }
  std::sort(set.begin(), set.end());
  std::vector<std::uint64_t> key;
  key.reserve(2 * set.size());
  for (const Member& member : set) {
    key.insert(key.end(), {member.node, std::bit_cast<std::uint64_t>(member.weight)});
  }
  Bounded bound;
  if (const Bounded* const found = known_.find(key)) {
    bound = *found;
  } else {
    bound = bound_members(set);
    if (depth < kDeepestSets) {
      if (const auto turned = turn_set(set, depth)) {
        bound = {std::min(bound.size, turned->size), std::min(bound.error, turned->error)};
      }
    }
    known_.add(key, bound);
  }
  constexpr double kRounded = 1 + 0x1p-30;
  return {bound.size * largest * kRounded, bound.error * largest * kRounded};
}

/// Returns the angle that turns the value closest to the results, or 0 if none is turned.
Angle SetBounds::nearest_turn(const Set& set) const {
  int highest = -1;
  Angle angle = 0;
  for (const Member& member : set) {
    if (turns_[member.node] != 0 && height_[member.node] > highest) {
      highest = height_[member.node];
      angle = turns_[member.node];
    }
  }
  return angle;
}

/// Expands the members by the sines and cosines of `angle`. A value that the angle does not turn
/// has a row and a column of its own.
std::vector<LinearForm> SetBounds::expand_rows(const Set& set, Angle angle) const {
  std::vector<LinearForm> forms;
  for (const Member& member : set) {
    auto form = expand_linear(graph_, polynomials_, member.node, angle);
    if (!form) form.emplace().turned.push_back({member.node, constant(1)});
    forms.push_back(std::move(*form));
  }
  split_sums(graph_, forms);
  gather_turned(forms);
  return forms;
}

SetBounds::Turn SetBounds::expand_set(const Set& set, Angle angle) const {
  Turn turn;
  turn.A.rows = set.size();
  turn.forms = expand_rows(set, angle);
  const std::vector<LinearForm>& forms = turn.forms;
  for (std::size_t row = 0; row < set.size(); ++row) {
    const double weight = set[row].weight;
    for (LinearTerm term : forms[row].turned) {
      const std::size_t column = turn.column(term.node);
      if (column == turn.leaves.size()) turn.leaves.push_back(term.node);
      for (double& x : term.factor.c) x *= weight;
      turn.A.entries.push_back({row, column, term.factor});
    }
    Bounded rest;
    for (const LinearTerm& term : forms[row].rest) {
      rest.size += weight * term.factor.magnitude() * bounds_[term.node]->size;
      rest.error += weight * term.factor.magnitude() * bounds_[term.node]->error;
    }
    turn.rest.push_back(rest);
  }
  turn.A.columns = turn.leaves.size();
  return turn;
}

/// Bounds the rounding of the operations that were expanded, plus the error of what is added: the
/// operations one by one, or those of a rotation together, whichever is less.
double SetBounds::bound_roundings(const Set& set, const Turn& turn,
                                  const std::vector<double>& scale, const Bounded& below,
                                  const Bounded& turned) const {
  TurnRounding products(set.size(), turn.leaves.size());
  double each = 0, others = 0, sums = 0;
  for (std::size_t row = 0; row < set.size(); ++row) {
    double of_each = turn.rest[row].error, of_others = turn.rest[row].error, of_sums = 0;
    for (const ExpandedOperation& expanded : turn.forms[row].operations) {
      const double error = set[row].weight * known_of_.local_error(expanded);
      of_each += error;
      const Node& n = graph_.nodes()[expanded.node];
      if (n.op != Op::mul) {
        (expanded.node == set[row].node ? of_sums : of_others) += error;
        continue;
      }
      const bool first = polynomials_[n.a].has_value();
      const std::uint32_t by = first ? n.a : n.b;
      const std::size_t column = turn.column(first ? n.b : n.a);
      const bool is_added = column < turn.leaves.size() &&
                            products.add(row, column, *polynomials_[by],
                                         set[row].weight * expanded.weight, bounds_[by]->error);
      if (!is_added) of_others += error;
    }
    each = std::hypot(each, of_each);
    others = std::hypot(others, of_others);
    sums = std::hypot(sums, of_sums);
  }
  // A sum is rounded by at most u times its computed value, so all sums of the set together by at
  // most u times its norm.
  sums = std::min(sums, turned.size + unit_ * (turned.error + each));
  const double of_products = products.bound(scale, below.size + unit_ * below.error, unit_);
  return std::min(each, of_products + others + sums);
}

std::optional<Bounded> SetBounds::turn_set(const Set& set, int depth) {
  const Angle angle = nearest_turn(set);
  if (angle == 0) return std::nullopt;
  const Turn turn = expand_set(set, angle);
  if (turn.leaves.empty() || turn.leaves.size() > kMostRows) return std::nullopt;
  const auto& [scale, norm] = norms_.of(turn.A);
  Set leaves;
  for (std::size_t i = 0; i < turn.leaves.size(); ++i) leaves.push_back({turn.leaves[i], scale[i]});
  const Bounded below = bound_set(std::move(leaves), depth + 1);
  double size = 0;
  for (const Bounded& rest : turn.rest) size = std::hypot(size, rest.size);
  size = (norm * below.size + size) * kSlack;
  const double brought = norm * below.error;
  const double added = bound_roundings(set, turn, scale, below, {size, brought});
  return Bounded{size, (brought + added) * kSlack};
}

}  // namespace treeline::bounds
