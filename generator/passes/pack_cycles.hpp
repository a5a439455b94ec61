#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Index of a pack for nodes that are in none.
inline constexpr int kNoPack = -1;

/// Finds packs that wait for themselves, through scalars or through other packs. The search is
/// depth-first over units, which are packs and single nodes; reaching an open unit again closes a
/// cycle. The graph of nodes has no cycle, so the pack that was opened last lies on it.
class PackCycles {
 public:
  /// `pack_of` gives for each node the index of its pack in `packs`, or kNoPack. The arguments must
  /// outlive this object.
  PackCycles(const std::vector<Node>& nodes, const std::vector<LanePack>& packs,
             const std::vector<int>& pack_of);

  /// Index of a pack on a cycle; nothing if there is no cycle. Take that pack apart before the next
  /// call.
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
  std::vector<std::uint32_t> open_units_;  ///< one node of each
  std::vector<std::size_t> open_packs_;
  std::uint32_t root_ = 0;  ///< node from which the search continues
};

}  // namespace treeline
