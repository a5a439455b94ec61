#pragma once

#include "description/mjcf/read_bodies.hpp"

namespace treeline {

/// Reads all `<equality>`: of two joints a mimic, `connect` and `weld` as joints
/// that close loops. Others are warnings.
void read_equalities(const std::vector<MjcfElement>& sections, MjcfTree& tree);

}  // namespace treeline
