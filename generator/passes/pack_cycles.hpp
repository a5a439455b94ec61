#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// In place of a pack's index: the node is in none.
inline constexpr int kNoPack = -1;

/// Finds packs that wait for themselves, by way of scalars or of other packs: depth-first over
/// units, packs and single nodes; meeting an open one again closes a cycle. The graph itself has
/// none, so the pack opened last is on it.
class PackCycles {
 public:
  /// `pack_of` gives the index into `packs` of each node's pack. All must outlive this.
  PackCycles(const std::vector<Node>& nodes, const std::vector<LanePack>& packs,
             const std::vector<int>& pack_of);

  /// A pack on a cycle, to be taken apart before the next is asked for; nothing when there is none.
  std::optional<std::size_t> next();

 private:
  enum class State : char { unseen, open, done };
  using Stack = std::vector<std::pair<std::uint32_t, bool>>;  // node, whether its operands are done

  template <class Visit>
  void for_each_in_unit(std::uint32_t node, Visit visit) const;
  void open(std::uint32_t node, Stack& stack);
  void close(std::uint32_t node);
  void forget_open();

  const std::vector<Node>& nodes_;
  const std::vector<LanePack>& packs_;
  const std::vector<int>& pack_of_;
  std::vector<State> state_;
  std::vector<std::uint32_t> open_units_;  ///< a node of each
  std::vector<std::size_t> open_packs_;
  std::uint32_t root_ = 0;  ///< from where the search goes on
};

}  // namespace treeline
