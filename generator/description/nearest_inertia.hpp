#pragma once

#include <optional>
#include <string>

#include "description/robot.hpp"

namespace treeline {

/// The possible inertia nearest to one that no body has: mass and centre of mass are kept, and of
/// the second moments of mass Sigma = tr(J) / 2 - J the negative eigenvalues become 0. That is the
/// least change of Sigma in the Frobenius norm; it does not depend on the axes. Entries are rounded
/// to 9 digits, those that change by less than 1e-9 of the largest stay; where this would leave
/// Sigma negative, its eigenvalues are raised to 1e-8 of its trace. Nothing where Sigma is not
/// negative beyond the rounding of figures, see `find_unphysical`.
std::optional<Inertial> nearest_possible_inertia(const Inertial& inertial);

/// Name of a possible body without extent: "a point", "a rod" along a line, "a plate" in a plane;
/// its second moments are of lower rank. Nothing for a body of full rank, without mass or
/// impossible. Such an inertia is no fault; that of a point or rod at the end of a chain may leave
/// the mass matrix singular.
std::optional<std::string> name_of_flat_body(const Inertial& inertial);

}  // namespace treeline
