#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bounds/bound_forms.hpp"
#include "bounds/node_bounds.hpp"
#include "bounds/norm_memo.hpp"
#include "program/program.hpp"

namespace treeline::bounds {

/// Largest magnitude of each input. Inputs are exact.
using InputSizes = std::vector<double>;

/// Bounds the magnitude of every node of a graph and the rounding error of its computed value.
///
/// Single nodes are bounded by |a + b| <= |a| + |b| and |a b| = |a| |b|, and their errors
/// accordingly (Wilkinson's running error analysis with bounds for values). That alone would let
/// vectors grow with every rotation: |c x + s y| <= |x| + |y|. So norms of sets of values are
/// bounded as well. The values of a set are written as sums of other values times sines and cosines
/// of one angle. The matrix of these factors has a 2-norm: 1 for rotations of vectors, and also of
/// symmetric matrices, whose entries off the diagonal weigh sqrt 2. The norm of the set is at most
/// this 2-norm times the norm of the other values. This continues down to the inputs. So rotations
/// cost nothing, and errors are carried through them in the same way.
class SetBounds {
 public:
  SetBounds(const Graph& graph, InputSizes inputs, double unit);
  SetBounds(const SetBounds&) = delete;  // its parts refer to each other
  SetBounds& operator=(const SetBounds&) = delete;

  /// Bound of the node. Nothing if it needs a division whose divisor may be zero.
  [[nodiscard]] std::optional<Bounded> of(std::uint32_t node) const;
  /// A division because of which the node has no bound. Nothing if the node has a bound.
  [[nodiscard]] std::optional<std::uint32_t> division_below(std::uint32_t node) const;

 private:
  void bound_node(std::uint32_t node);
  [[nodiscard]] Bounded bound_alone(std::uint32_t node);
  Bounded bound_set(Set set, int depth);
  [[nodiscard]] Bounded bound_members(const Set& set) const;
  [[nodiscard]] double bound_polynomials(const Set& set) const;
  std::optional<Bounded> turn_set(const Set& set, int depth);
  [[nodiscard]] Angle nearest_turn(const Set& set) const;
  struct Turn;
  [[nodiscard]] std::vector<LinearForm> expand_rows(const Set& set, Angle angle) const;
  [[nodiscard]] Turn expand_set(const Set& set, Angle angle) const;
  [[nodiscard]] double bound_roundings(const Set& set, const Turn& turn,
                                       const std::vector<double>& scale, const Bounded& below,
                                       const Bounded& turned) const;
  void improve(std::uint32_t node, const Bounded& bound);

  const Graph& graph_;
  InputSizes inputs_;
  double unit_;
  std::vector<std::optional<TrigPolynomial>> polynomials_;
  NodeBounds known_of_;
  std::vector<std::optional<Bounded>>& bounds_ = known_of_.bounds;
  NormMemo norms_;
  FormBounds forms_;
  std::vector<std::uint32_t> divisions_;  ///< by node without bound
  std::vector<int> height_;               ///< number of operations on the longest path to an input
  std::vector<Angle> turns_;              ///< see `find_turn`
  WordMemo<Bounded> known_;               ///< by sets
};

}  // namespace treeline::bounds
