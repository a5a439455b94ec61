#include <algorithm>
#include <bit>
#include <compare>
#include <cstdint>
#include <iterator>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"
#include "passes/rewriter.hpp"
#include "program/hash_word.hpp"

namespace treeline {
namespace {

/// Operand of a sum or product: a node, or a pair found before (numbered after the nodes). Factors
/// have no sign.
struct Item {
  std::uint32_t id = 0;
  bool negative = false;
};

/// Two items, the one with the smaller id first. A common sign is taken out, so the first item is
/// positive. Pairs are compared and sorted so often that they are one number: whether they are a
/// product, the ids (of less than 31 bits), and the sign of the second.
class Pair {
 public:
  Pair(bool is_product, Item a, Item b)
      : bits_((is_product ? kProduct : 0) | std::uint64_t{std::min(a.id, b.id)} << 32 |
              std::uint64_t{std::max(a.id, b.id)} << 1 | (a.negative != b.negative ? 1U : 0U)) {}

  [[nodiscard]] bool is_product() const { return (bits_ & kProduct) != 0; }
  [[nodiscard]] Item a() const { return {static_cast<std::uint32_t>(bits_ >> 32) & kId, false}; }
  [[nodiscard]] Item b() const {
    return {static_cast<std::uint32_t>(bits_ >> 1) & kId, (bits_ & 1U) != 0};
  }
  auto operator<=>(const Pair&) const = default;
  [[nodiscard]] std::uint64_t hash() const { return hash_word(0, bits_); }

 private:
  static constexpr std::uint64_t kProduct = std::uint64_t{1} << 63;
  static constexpr std::uint32_t kId = 0x7fffffff;

  std::uint64_t bits_;
};

/// A sum or product as a whole, across the nodes that make it up.
struct Group {
  std::uint32_t node = 0;
  bool is_product = false;
  std::size_t first = 0, items = 0;  ///< in `Groups::items`
};
struct Groups {
  std::vector<Group> list;
  std::vector<Item> items;  ///< of one group after the other

  [[nodiscard]] std::span<Item> items_of(const Group& group) {
    return std::span(items).subspan(group.first, group.items);
  }
  [[nodiscard]] std::span<const Item> items_of(const Group& group) const {
    return std::span(items).subspan(group.first, group.items);
  }
};

/// Occurrences of pairs: (pair, index of the group), sorted.
using Occurrences = std::vector<std::pair<Pair, std::uint32_t>>;

/// All groups, and the pairs that occur in several of them. A group gains pairs only through a
/// substitution, which introduces a new item. So the groups of a pair are searched once, and after
/// that only become fewer.
class PairTable {
 public:
  PairTable(Groups groups, std::uint32_t first_pair)
      : groups_(std::move(groups)), first_pair_(first_pair) {
    queue_frequent(find_repeated());
  }

  /// Replaces the most frequent pair wherever it occurs. Returns false if no pair occurs twice.
  bool share_one() {
    while (!queue_.empty()) {
      const auto [minus_count, pair, index] = *queue_.begin();
      queue_.erase(queue_.begin());
      std::vector<std::size_t>& where = places_[index];
      // clang++ 14 can capture a structured binding only under another name.
      std::erase_if(where,
                    [&, &wanted = pair](std::size_t group) { return !has_pair(group, wanted); });
      if (static_cast<int>(where.size()) == -minus_count) {
        share(pair, where);
        return true;
      }
      if (where.size() > 1) {
        queue_.insert({-static_cast<int>(where.size()), pair, index});
      }
    }
    return false;
  }

  [[nodiscard]] const Groups& groups() const { return groups_; }
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  template <class Visit>
  void for_each_pair(std::size_t group, Visit visit) const {
    const Group& of = groups_.list[group];
    const std::span<const Item> items = groups_.items_of(of);
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        visit(Pair(of.is_product, items[i], items[j]));
      }
    }
  }

  /// The occurrences of pairs that may occur twice. Most pairs occur once; a table of counts by
  /// hash tells that of most of these without sorting them.
  [[nodiscard]] Occurrences find_repeated() const {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < groups_.list.size(); ++i) {
      for_each_pair(i, [&pairs](const Pair&) { ++pairs; });
    }
    std::vector<std::uint8_t> counts(std::bit_ceil(4 * pairs + 1), 0);
    const auto count_of = [&counts](const Pair& pair) -> std::uint8_t& {
      return counts[pair.hash() & (counts.size() - 1)];
    };
    for (std::size_t i = 0; i < groups_.list.size(); ++i) {
      for_each_pair(i, [&count_of](const Pair& pair) {
        std::uint8_t& count = count_of(pair);
        count = count == 0 ? 1 : 2;
      });
    }
    Occurrences found;
    for (std::size_t i = 0; i < groups_.list.size(); ++i) {
      for_each_pair(i, [&](const Pair& pair) {
        if (count_of(pair) > 1) found.emplace_back(pair, static_cast<std::uint32_t>(i));
      });
    }
    return found;
  }

  [[nodiscard]] bool has_pair(std::size_t group, const Pair& pair) const {
    bool found = false;
    for_each_pair(group, [&](const Pair& other) { found = found || other == pair; });
    return found;
  }

  /// Queues the pairs that occur in several groups.
  void queue_frequent(Occurrences found) {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (auto first = found.begin(); first != found.end();) {
      const auto last =
          std::find_if(first, found.end(), [&](const auto& o) { return o.first != first->first; });
      if (last - first > 1) {
        queue_.insert({-static_cast<int>(last - first), first->first, places_.size()});
        std::vector<std::size_t>& where = places_.emplace_back();
        std::transform(first, last, std::back_inserter(where),
                       [](const auto& o) { return o.second; });
      }
      first = last;
    }
  }

  void share(const Pair& pair, std::vector<std::size_t> where) {
    const Item shared{first_pair_ + static_cast<std::uint32_t>(pairs_.size()), false};
    pairs_.push_back(pair);
    Occurrences found;
    for (const std::size_t group : where) {
      substitute(groups_.list[group], pair, shared);
      for_each_pair(group, [&](const Pair& other) {
        if (other.b().id == shared.id || other == pair) {
          found.emplace_back(other, static_cast<std::uint32_t>(group));
        }
      });
    }
    queue_frequent(std::move(found));
  }

  /// Replaces one occurrence of the pair by the item `shared`, with the sign of the pair's first
  /// item.
  void substitute(Group& group, const Pair& pair, Item shared) {
    const std::span<Item> items = groups_.items_of(group);
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        if (Pair(pair.is_product(), items[i], items[j]) == pair) {
          shared.negative = (items[i].id <= items[j].id ? items[i] : items[j]).negative;
          items[i] = shared;
          std::shift_left(items.begin() + static_cast<std::ptrdiff_t>(j), items.end(), 1);
          --group.items;
          return;
        }
      }
    }
  }

  Groups groups_;
  std::uint32_t first_pair_;
  std::vector<Pair> pairs_;
  std::vector<std::vector<std::size_t>> places_;        // by index: groups with the pair
  std::set<std::tuple<int, Pair, std::size_t>> queue_;  // minus the largest count, pair, index
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

  /// Whether the node is part of the group of its only user.
  [[nodiscard]] bool dissolves(std::uint32_t node) const {
    const Op op = nodes_[node].op;
    const Op user = nodes_[user_[node]].op;
    return uses_[node] == 1 && ((is_sum(op) && is_sum(user)) || (op == Op::mul && user == Op::mul));
  }

  [[nodiscard]] Groups groups() const {
    Groups groups;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const Op op = nodes_[i].op;
      if (uses_[i] > 0 && (is_sum(op) || op == Op::mul) && !dissolves(i)) {
        const std::size_t first = groups.items.size();
        collect(i, false, groups.items);
        groups.list.push_back({i, op == Op::mul, first, groups.items.size() - first});
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

/// Builds the values of groups from their items. A pair that is built several times becomes one
/// node, because nodes are interned.
class GroupBuilder {
 public:
  GroupBuilder(const PairTable& table, const Rewriter& rewriter, std::uint32_t first_pair)
      : table_(table), rewriter_(rewriter), first_pair_(first_pair) {}

  [[nodiscard]] Expression build(const Group& group) const {
    const std::span<const Item> items = table_.groups().items_of(group);
    Expression value = build(items.front());
    for (const Item& item : items.subspan(1)) {
      value = join(group.is_product, value, build(item));
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
      value = join(pair.is_product(), build(pair.a()), build(pair.b()));
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
  for (const Group& group : table.groups().list) {
    const std::span<const Item> items = table.groups().items_of(group);
    const bool shares = std::any_of(items.begin(), items.end(),
                                    [&](const Item& item) { return item.id >= first_pair; });
    group_of[group.node] = shares ? &group : nullptr;  // groups without a pair stay as they are
  }
  return Rewriter(program).run([&](std::uint32_t node, const Rewriter& rewriter) {
    return group_of[node] == nullptr
               ? rewriter.copy(node)
               : GroupBuilder(table, rewriter, first_pair).build(*group_of[node]);
  });
}

}  // namespace treeline
