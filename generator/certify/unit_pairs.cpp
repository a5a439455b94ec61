#include "certify/unit_pairs.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include "functions/quantity.hpp"

namespace treeline {
namespace {

constexpr int kMostFactors = 6;  // angles whose sum may be a pair

void add_to(LinearRow& row, std::uint32_t node, int factor) {
  const int sum = row[node] += factor;
  if (sum == 0) row.erase(node);
}

bool is_sum_or_minus(Op op) {
  return is_sum(op) || op == Op::neg;
}

}  // namespace

LinearRow operator-(LinearRow row) {
  for (auto& [node, factor] : row) factor = -factor;
  return row;
}

LinearRow without_sign(LinearRow row) {
  return !row.empty() && row.begin()->second < 0 ? -std::move(row) : row;
}

bool are_mates(const TurnedRow& a, const TurnedRow& b) {
  return (b.cosine == a.sine && b.sine == -a.cosine) || (b.cosine == -a.sine && b.sine == a.cosine);
}

UnitPairs::UnitPairs(const Graph& graph)
    : graph_(graph), turns_(graph.nodes().size()), height_(graph.nodes().size()) {
  find_angles();
  for (int i = 0; i < kMostFactors; ++i) find_products();
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    const Node& node = graph.nodes()[i];
    const int operands = operation(node.op).operands;
    if (operands > 0) height_[i] = height_[node.a] + 1;
    if (operands > 1) height_[i] = std::max(height_[i], height_[node.b] + 1);
    turns_[i] = find_turn(i);
  }
}

void UnitPairs::add_pair(UnitPair pair) {
  members_[pair.cosine] = {all_.size(), false};
  members_[pair.sine] = {all_.size(), true};
  all_.push_back(pair);
}

/// Sines and cosines of one angle, computed or given as inputs `sin_q[3]` and `cos_q[3]`.
void UnitPairs::find_angles() {
  std::map<std::string, UnitPair> angles;
  for (std::uint32_t i = 0; i < graph_.nodes().size(); ++i) {
    const Node& node = graph_.nodes()[i];
    std::string angle;
    bool sine = node.op == Op::sin;
    if (is_trigonometric(node.op)) angle = std::to_string(node.a);
    if (node.op == Op::input) {
      const std::string& name = graph_.inputs()[node.a];
      const auto quantity = quantity_of_input(name);
      sine = quantity == Quantity::sin_q;
      if (sine || quantity == Quantity::cos_q) angle = name.substr(name.find('['));
    }
    if (!angle.empty()) (sine ? angles[angle].sine : angles[angle].cosine) = i;
  }
  for (const auto& [angle, pair] : angles) {
    if (pair.sine != 0 && pair.cosine != 0) add_pair(pair);
  }
}

/// Pairs of sums that turn one pair by another.
void UnitPairs::find_products() {
  std::vector<std::pair<std::uint32_t, TurnedRow>> found;
  for (std::uint32_t i = 0; i < graph_.nodes().size(); ++i) {
    if (!is_sum(graph_.nodes()[i].op) || members_.contains(i)) continue;
    const auto by = find_turn(i);
    if (!by) continue;
    const TurnedRow row = expand({{i, 1}}, *by);
    const bool one_each = row.rest.empty() && row.cosine.size() == 1 && row.sine.size() == 1;
    if (!one_each || !is_pair({row.cosine, row.sine})) continue;
    const auto mate = std::find_if(found.begin(), found.end(), [&](const auto& other) {
      return pair_of(row.cosine.begin()->first) == pair_of(other.second.cosine.begin()->first) &&
             find_turn(other.first) == by && are_mates(row, other.second) &&
             !members_.contains(other.first);
    });
    if (mate == found.end()) {
      found.emplace_back(i, row);
    } else {
      add_pair({mate->first, i, by, pair_of(row.cosine.begin()->first)});
    }
  }
}

std::optional<std::size_t> UnitPairs::pair_of(std::uint32_t node) const {
  const auto found = members_.find(node);
  return found == members_.end() ? std::nullopt : std::optional(found->second.pair);
}

bool UnitPairs::is_pair(const std::vector<LinearRow>& rows) const {
  if (rows.size() != 2 || rows[0].size() != 1 || rows[1].size() != 1) return false;
  const auto [a, factor_a] = *rows[0].begin();
  const auto [b, factor_b] = *rows[1].begin();
  return a != b && factor_a * factor_a == 1 && factor_b * factor_b == 1 && pair_of(a) &&
         pair_of(a) == pair_of(b);
}

std::optional<std::size_t> UnitPairs::last_turn(const std::vector<LinearRow>& rows) const {
  int highest = -1;
  std::optional<std::size_t> last;
  for (const LinearRow& row : rows) {
    for (const auto& [node, factor] : row) {
      if (!turns_[node] || height_[node] <= highest) continue;
      highest = height_[node];
      last = turns_[node];
    }
  }
  return last;
}

std::optional<UnitPairs::Product> UnitPairs::as_product(std::uint32_t node,
                                                        std::optional<std::size_t> pair) const {
  const Node& n = graph_.nodes()[node];
  if (n.op != Op::mul) return std::nullopt;
  for (const auto& [by, of] : {std::pair{n.a, n.b}, std::pair{n.b, n.a}}) {
    const auto found = pair_of(by);
    if (found && (!pair || found == pair)) return Product{*found, by, of};
  }
  return std::nullopt;
}

std::optional<std::size_t> UnitPairs::find_turn(std::uint32_t node) const {
  constexpr int kMostNodes = 64;
  std::deque<std::uint32_t> next{node};
  for (int seen = 0; !next.empty() && seen < kMostNodes; ++seen) {
    const std::uint32_t i = next.front();
    next.pop_front();
    if (const auto product = as_product(i, std::nullopt)) return product->pair;
    const Node& n = graph_.nodes()[i];
    if (!is_sum_or_minus(n.op)) continue;
    next.push_back(n.a);
    if (n.op != Op::neg) next.push_back(n.b);
  }
  return std::nullopt;
}

bool UnitPairs::turns(std::uint32_t node, std::size_t pair) const {
  if (as_product(node, pair)) return true;
  const Node& n = graph_.nodes()[node];
  return is_sum_or_minus(n.op) && (turns(n.a, pair) || (n.op != Op::neg && turns(n.b, pair)));
}

void UnitPairs::expand(std::uint32_t node, int factor, std::size_t pair, TurnedRow& row) const {
  const Node& n = graph_.nodes()[node];
  if (const auto product = as_product(node, pair)) {
    add_to(members_.at(product->by).is_sine ? row.sine : row.cosine, product->of, factor);
  } else if (is_sum_or_minus(n.op) && turns(node, pair)) {
    expand(n.a, n.op == Op::neg ? -factor : factor, pair, row);
    if (n.op != Op::neg) expand(n.b, n.op == Op::sub ? -factor : factor, pair, row);
  } else {
    add_to(row.rest, node, factor);
  }
}

TurnedRow UnitPairs::expand(const LinearRow& row, std::size_t pair) const {
  TurnedRow turned;
  for (const auto& [node, factor] : row) expand(node, factor, pair, turned);
  return turned;
}

}  // namespace treeline
