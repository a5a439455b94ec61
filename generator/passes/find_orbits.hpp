#pragma once

#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Exchanging the limbs of a family, inputs and constants, maps every operation that another limb
/// does too to that of the next limb. The groups of live operations that follow each other so, by
/// limb; node 0 where a limb lacks one. As many places as the next power of two, at most the
/// graph's lanes.
std::vector<LanePack> find_orbits(const Program& program);

}  // namespace treeline
