#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// A sum of nodes, each times a whole number.
using LinearRow = std::map<std::uint32_t, int>;

/// The row times the sign that makes its first number positive.
LinearRow without_sign(LinearRow row);
LinearRow operator-(LinearRow row);

/// Two nodes whose squares add up to 1: cosine and sine of one angle, or of a sum of angles.
struct UnitPair {
  std::uint32_t cosine = 0, sine = 0;
  /// Factors of a pair that is a product: the pair that turns, and the pair that is turned.
  std::optional<std::size_t> by, of;
};

/// A row as cosine times a row, plus sine times a row, plus the rest.
struct TurnedRow {
  LinearRow cosine, sine, rest;
  [[nodiscard]] bool is_turned() const { return !cosine.empty() || !sine.empty(); }
};

/// Finds where a graph turns vectors: sums of products of a pair's cosine and sine with values.
class UnitPairs {
 public:
  explicit UnitPairs(const Graph& graph);

  [[nodiscard]] const std::vector<UnitPair>& all() const { return all_; }
  /// The pair to whose pair the node belongs.
  [[nodiscard]] std::optional<std::size_t> pair_of(std::uint32_t node) const;
  /// The pair by which the node's value is turned last.
  [[nodiscard]] std::optional<std::size_t> turn(std::uint32_t node) const { return turns_[node]; }
  [[nodiscard]] TurnedRow expand(const LinearRow& row, std::size_t pair) const;
  /// Whether the rows are a pair's cosine and sine.
  [[nodiscard]] bool is_pair(const std::vector<LinearRow>& rows) const;
  /// The pair that turns the value of these rows that is closest to the results.
  [[nodiscard]] std::optional<std::size_t> last_turn(const std::vector<LinearRow>& rows) const;

  /// A product of the pair's cosine or sine (which `by` is) with another node.
  struct Product {
    std::size_t pair = 0;
    std::uint32_t by = 0, of = 0;
  };
  /// The node as such a product with this pair, or with any.
  [[nodiscard]] std::optional<Product> as_product(std::uint32_t node,
                                                  std::optional<std::size_t> pair) const;
  /// Whether a term of the sum is such a product.
  [[nodiscard]] bool turns(std::uint32_t node, std::size_t pair) const;

 private:
  struct Member {
    std::size_t pair = 0;
    bool is_sine = false;
  };
  void find_angles();
  void find_products();
  void add_pair(UnitPair pair);
  [[nodiscard]] std::optional<std::size_t> find_turn(std::uint32_t node) const;
  void expand(std::uint32_t node, int factor, std::size_t pair, TurnedRow& row) const;

  const Graph& graph_;
  std::vector<UnitPair> all_;
  std::map<std::uint32_t, Member> members_;
  std::vector<std::optional<std::size_t>> turns_;
  std::vector<int> height_;  ///< number of operations on the longest path to an input
};

/// Whether two turned rows are the two coordinates of one turned vector.
bool are_mates(const TurnedRow& a, const TurnedRow& b);

}  // namespace treeline
