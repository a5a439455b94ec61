#pragma once

#include <optional>
#include <span>

#include "interpreter/points.hpp"

namespace treeline {

/// Two joints whose inertias differ so much that Lambda^-1, in which both count, keeps few digits
/// of what the heavy one contributes.
struct MassRatio {
  int light = 0, heavy = 0;  ///< entries of qd
  double share = 1;          ///< ratio of their contributions to Lambda^-1, light to heavy
  double condition = 1;      ///< factor by which this increases the condition number of Lambda^-1
};

/// Finds two such joints. With M = U U^T, U upper triangular, the columns of J U^-T are the
/// contributions of the joints to Lambda^-1 = J U^-T U^-1 J^T, with the joints behind them free:
/// the lighter, the larger. The cost of the inertias is the condition number of Lambda^-1 divided
/// by the one that these columns would have if they were all of one size. The result is the least
/// of all states. Nothing if M is not positive definite in any of them.
std::optional<MassRatio> find_mass_ratio(const interpreter::Model<double>& model,
                                         const interpreter::Points<double>& points,
                                         std::span<const interpreter::Vector<double>> states);

}  // namespace treeline
