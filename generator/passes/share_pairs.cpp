#include "passes/share_pairs.hpp"

#include <algorithm>
#include <compare>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "passes/rebuild.hpp"
#include "passes/rewriter.hpp"

namespace treeline {
namespace {

bool is_sum(Op op) {
  return op == Op::add || op == Op::sub;
}

/// What sums add and products multiply: a node, or a pair already found (numbered after the nodes).
/// Factors have no sign.
struct Item {
  std::uint32_t id = 0;
  bool negative = false;
  auto operator<=>(const Item&) const = default;
};

/// Two items, the smaller first, up to a common sign: that of the first is plus.
struct Pair {
  bool is_product = false;
  Item a, b;
  auto operator<=>(const Pair&) const = default;
};

Pair make_pair_of(bool is_product, Item a, Item b) {
  if (b.id < a.id) {
    std::swap(a, b);
  }
  return {is_product, {a.id, false}, {b.id, a.negative != b.negative}};
}

/// A sum or product as a whole.
struct Group {
  std::uint32_t node = 0;
  bool is_product = false;
  std::vector<Item> items;
};

/// All groups and how often each pair occurs among them.
class PairTable {
 public:
  PairTable(std::vector<Group> groups, std::uint32_t first_pair)
      : groups_(std::move(groups)), first_pair_(first_pair) {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      add_pairs(i);
    }
  }

  /// Replaces the most frequent pair wherever it occurs. False when none occurs twice.
  bool share_one() {
    if (by_count_.empty() || by_count_.begin()->first > -2) {
      return false;
    }
    const Pair pair = by_count_.begin()->second;
    const std::set<std::size_t> where = occurrences_[pair];
    const Item shared{first_pair_ + static_cast<std::uint32_t>(pairs_.size()), false};
    pairs_.push_back(pair);
    for (const std::size_t group : where) {
      remove_pairs(group);
      substitute(groups_[group].items, pair, shared);
      add_pairs(group);
    }
    return true;
  }

  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  template <class Visit>
  void for_each_pair(std::size_t group, Visit visit) const {
    const std::vector<Item>& items = groups_[group].items;
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        visit(make_pair_of(groups_[group].is_product, items[i], items[j]));
      }
    }
  }

  void add_pairs(std::size_t group) {
    for_each_pair(group, [&](const Pair& pair) {
      std::set<std::size_t>& where = occurrences_[pair];
      by_count_.erase({-static_cast<int>(where.size()), pair});
      where.insert(group);
      by_count_.insert({-static_cast<int>(where.size()), pair});
    });
  }

  void remove_pairs(std::size_t group) {
    for_each_pair(group, [&](const Pair& pair) {
      std::set<std::size_t>& where = occurrences_[pair];
      by_count_.erase({-static_cast<int>(where.size()), pair});
      where.erase(group);
      if (!where.empty()) {
        by_count_.insert({-static_cast<int>(where.size()), pair});
      }
    });
  }

  /// One occurrence of the pair becomes the item `shared`, with the sign that `a` had.
  static void substitute(std::vector<Item>& items, const Pair& pair, Item shared) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        if (make_pair_of(pair.is_product, items[i], items[j]) == pair) {
          shared.negative = (items[i].id <= items[j].id ? items[i] : items[j]).negative;
          items[i] = shared;
          items.erase(items.begin() + static_cast<std::ptrdiff_t>(j));
          return;
        }
      }
    }
  }

  std::vector<Group> groups_;
  std::uint32_t first_pair_;
  std::vector<Pair> pairs_;
  std::map<Pair, std::set<std::size_t>> occurrences_;
  std::set<std::pair<int, Pair>> by_count_;  // most frequent first
};

/// Finds the groups of a program.
class Grouping {
 public:
  explicit Grouping(const Program& program)
      : nodes_(program.graph.nodes()), uses_(count_uses(program)), user_(nodes_.size(), 0) {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (uses_[i] > 0 && operation(nodes_[i].op).operands == 2) {
        user_[nodes_[i].a] = i;
        user_[nodes_[i].b] = i;
      }
    }
  }

  /// Part of the group of its only user.
  [[nodiscard]] bool dissolves(std::uint32_t node) const {
    const Op op = nodes_[node].op;
    const Op user = nodes_[user_[node]].op;
    return uses_[node] == 1 && ((is_sum(op) && is_sum(user)) || (op == Op::mul && user == Op::mul));
  }

  [[nodiscard]] std::vector<Group> groups() const {
    std::vector<Group> groups;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const Op op = nodes_[i].op;
      if (uses_[i] > 0 && (is_sum(op) || op == Op::mul) && !dissolves(i)) {
        groups.push_back({i, op == Op::mul, {}});
        collect(i, false, groups.back().items);
      }
    }
    return groups;
  }

 private:
  void collect(std::uint32_t node, bool negative, std::vector<Item>& items) const {
    for (const auto& [operand, minus] : {std::pair{nodes_[node].a, false},
                                         std::pair{nodes_[node].b, nodes_[node].op == Op::sub}}) {
      if (dissolves(operand)) {
        collect(operand, negative != minus, items);
      } else {
        items.push_back({operand, negative != minus});
      }
    }
  }

  const std::vector<Node>& nodes_;
  std::vector<int> uses_;
  std::vector<std::uint32_t> user_;
};

/// Builds groups from their items. Interning makes one node of a pair however often it is built.
class GroupBuilder {
 public:
  GroupBuilder(const PairTable& table, const Rewriter& rewriter, std::uint32_t first_pair)
      : table_(table), rewriter_(rewriter), first_pair_(first_pair) {}

  [[nodiscard]] Expression build(const Group& group) const {
    Expression value = build(group.items.front());
    for (std::size_t i = 1; i < group.items.size(); ++i) {
      value = join(group.is_product, value, build(group.items[i]));
    }
    return value;
  }

 private:
  [[nodiscard]] Expression build(Item item) const {
    Expression value;
    if (item.id < first_pair_) {
      value = rewriter_.value(item.id);
    } else {
      const Pair& pair = table_.pairs()[item.id - first_pair_];
      value = join(pair.is_product, build(pair.a), build(pair.b));
    }
    return item.negative ? -value : value;
  }

  static Expression join(bool is_product, Expression a, Expression b) {
    return is_product ? a * b : a + b;
  }

  const PairTable& table_;
  const Rewriter& rewriter_;
  std::uint32_t first_pair_;
};

}  // namespace

Program share_pairs(const Program& program) {
  const Grouping grouping(program);
  const auto first_pair = static_cast<std::uint32_t>(program.graph.nodes().size());
  PairTable table(grouping.groups(), first_pair);
  while (table.share_one()) {
  }
  std::vector<const Group*> group_of(first_pair, nullptr);
  for (const Group& group : table.groups()) {
    const bool shares = std::any_of(group.items.begin(), group.items.end(),
                                    [&](const Item& item) { return item.id >= first_pair; });
    group_of[group.node] = shares ? &group : nullptr;  // the others stay as they are
  }
  return Rewriter(program).run([&](std::uint32_t node, const Rewriter& rewriter) {
    return group_of[node] == nullptr
               ? rewriter.copy(node)
               : GroupBuilder(table, rewriter, first_pair).build(*group_of[node]);
  });
}

}  // namespace treeline
