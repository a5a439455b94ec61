#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/sdf/sdf_model.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Joints that make the tree, and joints that close loops.
struct SdfTree {
  std::vector<SdfJoint> joints;  ///< of the tree, each led away from the root, in its order
  std::vector<SdfJoint> loops;   ///< as in the file
  bool has_world = false;        ///< the root is the world, else the model's first link
};

/// Spans the tree from the world, or from the first link where no joint holds to the world: always
/// by the first joint of the file that leads from a reached link to one that is not, and, only if
/// there is none, against the direction of the first that ends in a reached link. So the last joint
/// of a loop closes it. An error in `diagnostics` where links stay unreached.
std::optional<SdfTree> span_tree(const SdfModel& model, const std::string& file,
                                 Diagnostics& diagnostics);

}  // namespace treeline
