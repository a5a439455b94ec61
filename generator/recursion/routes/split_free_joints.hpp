#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {

/// A robot each of whose joints beyond the base moves along or about one axis.
struct SplitTree {
  Tree<double> tree;
  std::vector<int> axes;    ///< of all links, see `LinkTypes::TlLinkBall::axis`
  std::vector<int> places;  ///< in `tree`, of all links of the mechanism
};

/// The tree of constants with floating joints beyond the base as six links each: three that slide
/// along the axes of the child and three that turn about them, of which the last has the body.
SplitTree split_free_joints(const Mechanism& mechanism);

}  // namespace treeline
