#pragma once

#include <span>

#include "program/program.hpp"

namespace treeline {

/// Operands of a pack, by lane.
struct LaneOperands {
  LanePack a, b;
};

/// Returns the left and right operands of a pack, by lane. Unary operations have no right operands
/// (all 0). Operands of a commutative operation are exchanged where this makes a lane more like the
/// first one: the same value, a value of the same aligned group, or a value of the same operation.
LaneOperands lane_operands(const Graph& graph, const LanePack& lanes);

/// Writes the operands of a pack to `left` and `right`, which have as many lanes.
void lane_operands(const Graph& graph, std::span<const std::uint32_t> lanes,
                   std::span<std::uint32_t> left, std::span<std::uint32_t> right);

}  // namespace treeline
