#pragma once

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Reads `<link>`: its name and its first `<inertial>`. Shapes and materials do not matter.
Link read_link(const UrdfElement& element);

/// The reciprocal of a smaller mass may leave the range of double.
inline constexpr double kSmallestMass = 1e-100;    ///< kg
inline constexpr double kSmallestMoment = 1e-100;  ///< kg m^2

/// The mass that a link with this one has: 0 where it is too small to compute with.
double counted_mass(double mass);

/// Makes the moments 0 if all are too small to compute with. Returns the largest that was lost, 0
/// if none was.
double drop_smallest_moments(Inertial& inertial);

}  // namespace treeline
