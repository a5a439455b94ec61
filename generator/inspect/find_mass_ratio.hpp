#pragma once

#include <optional>
#include <span>

#include "interpreter/points.hpp"

namespace treeline {

/// Two joints whose inertias differ so much that Lambda^-1, where both count, holds few digits of
/// what the heavy one adds.
struct MassRatio {
  int light = 0, heavy = 0;  ///< entries of qd
  double share = 1;          ///< by how much more the light one adds to Lambda^-1
  double condition = 1;      ///< by how much this makes Lambda^-1 worse
};

/// With M = U U^T, U upper triangular, the columns of J U^-T say what each joint adds to
/// Lambda^-1 = J U^-T U^-1 J^T, those behind it free: as much as it is light. The condition of
/// Lambda^-1, over the one that these columns would have if all added as much, is what the inertias
/// cost; the least of all states. Nothing where M is not positive definite in any.
std::optional<MassRatio> find_mass_ratio(const interpreter::Model<double>& model,
                                         const interpreter::Points<double>& points,
                                         std::span<const interpreter::Vector<double>> states);

}  // namespace treeline
