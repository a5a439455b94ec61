#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "program/link_loops.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {

/// The table of the robot's links, the same for all functions if `mechanism` is, over which
/// functions loop; with its operational points and their rows on demand.
LinkTableData make_link_table(const Mechanism& mechanism, bool with_points);

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
