#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// Subtrees of one shape on one link, the whole of each: the same kinds of joints branching in the
/// same way, whatever their measures. Limbs in limbs are not listed again. Families with more than
/// `most` limbs are left out.
std::vector<LimbFamily> find_limbs(const Mechanism& mechanism, int most);

}  // namespace treeline
