#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// Finds families of limbs: isomorphic complete subtrees on one link, with the same kinds of joints
/// and the same branches, whatever their dimensions. Limbs within limbs are not listed separately.
/// Families of more than `most` limbs are left out.
std::vector<LimbFamily> find_limbs(const Mechanism& mechanism, int most);

}  // namespace treeline
