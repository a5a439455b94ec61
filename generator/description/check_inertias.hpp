#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Principal moments of an inertial, ascending, in kg m^2.
std::array<double, 3> principal_moments(const Inertial& inertial);

/// Reason, in words with the numbers, that no distribution of mass has this inertia: a negative
/// principal moment, or one that exceeds the sum of the other two beyond the rounding of figures in
/// a file (1e-4 of the largest); moments without mass. Nothing when the inertial is physical.
std::optional<std::string> find_unphysical(const Inertial& inertial);

/// Warns of each inertial that is not physical. The equations of motion are still those of the
/// numbers given, so it is no error.
void check_inertias(const Robot& robot, const std::vector<UrdfElement>& elements);

}  // namespace treeline
