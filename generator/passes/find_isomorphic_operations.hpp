#pragma once

#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Finds operations that isomorphic limbs share. Exchanging each limb of a family for the next one,
/// with its inputs and constants, maps an operation of one limb to the same operation of the next.
/// Each group holds the live operations that follow one another in this way, ordered by limb, with
/// node 0 where a limb lacks one. Its length is the number of limbs, rounded up to a power of two,
/// and at most the graph's number of lanes.
std::vector<LanePack> find_isomorphic_operations(const Program& program);

}  // namespace treeline
