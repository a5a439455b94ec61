#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/flat/flat_model.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Spans the tree from the world, or from the first link where no joint holds to the world: always
/// by the first joint of the file that leads from a reached link to one that is not, and, only if
/// there is none, against the direction of the first that ends in a reached link. So the last joint
/// of a loop closes it. An error in `diagnostics` where links stay unreached.
std::optional<FlatTree> span_tree(const FlatModel& model, const std::string& file,
                                  Diagnostics& diagnostics);

}  // namespace treeline
