#pragma once

#include "program/program.hpp"

namespace treeline {

/// What the lanes of a pack read.
struct LaneOperands {
  LanePack a, b;
};

/// The left and right operands of a pack's lanes; no right ones (all 0) where there is one operand.
/// Those of a commutative operation are exchanged
/// where that makes them more like the first lane's: the same value, of the same aligned group, or
/// the same operation.
LaneOperands lane_operands(const Graph& graph, const LanePack& lanes);

}  // namespace treeline
