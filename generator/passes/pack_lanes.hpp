#pragma once

#include "program/program.hpp"

namespace treeline {

/// Finds operations that can share registers of `program.graph.lane_width()` lanes and lists them
/// in `packs`; the graph does not change. The search starts from the groups that the trace aligned
/// and follows their operands as long as all lanes have the same operation (superword-level
/// parallelism, Larsen & Amarasinghe 2000). A pack stays if it saves more operations than are
/// needed to bring scalars into lanes and take them out again, and if no two packs wait for each
/// other.
Program pack_lanes(const Program& program);

}  // namespace treeline
