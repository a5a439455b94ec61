#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Principal moments of an inertial, ascending, in kg m^2; 0 where they are rounding errors.
std::array<double, 3> principal_moments(const Inertial& inertial);

/// Reason, in words with the numbers, that no distribution of mass has this inertia: a negative
/// principal moment, or one that exceeds the sum of the other two beyond the rounding of figures in
/// a file (1e-4 of the largest); moments without mass. Nothing when the inertial is physical.
std::optional<std::string> find_unphysical(const Inertial& inertial);

/// Warns of each inertial that is not physical. The equations of motion are still those of the
/// numbers given, so it is no error.
void check_inertias(const Robot& robot, const std::vector<UrdfElement>& elements);

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
