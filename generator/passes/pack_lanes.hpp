#pragma once

#include "program/program.hpp"

namespace treeline {

/// Finds operations that can share registers of `program.graph.lane_width()` lanes and lists them
/// in `packs`; the graph is the same. Starts from the groups that the trace aligned and follows
/// operands as long as they are the same operation in every lane (superword-level parallelism,
/// Larsen & Amarasinghe 2000). A pack stays if it saves more operations than bringing scalars into
/// lanes and taking them out again costs, and if no two packs wait for each other.
Program pack_lanes(const Program& program);

}  // namespace treeline
