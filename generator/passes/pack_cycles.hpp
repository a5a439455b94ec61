#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// In place of a pack's index: the node is in none.
inline constexpr int kNoPack = -1;

/// A pack that waits for itself, by way of scalars or of other packs; nothing when there is none.
/// `pack_of` gives the index into `packs` of each node's pack.
std::optional<std::size_t> find_pack_on_cycle(const std::vector<Node>& nodes,
                                              const std::vector<LanePack>& packs,
                                              const std::vector<int>& pack_of);

}  // namespace treeline
