#pragma once

#include "description/robot.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// What a file's doubles mean, in 50 digits; quarter turns are exact, see `sin_cos_of_file_angle`.
ExactPose exact_pose(const Pose& pose);

/// Second moment of a body with inertia J about its centre of mass: Sigma = tr(J)/2 1 - J, carried
/// to the link's frame.
Inertia exact_inertia(const Inertial& body);

/// sqrt(tr(Sigma) / m), about the frame's origin; 0 for what no body has.
Exact radius_of_gyration(const Inertia& inertia);

/// The shortest rotation that takes z to the unit vector `axis`; half a turn about x for -z. Near
/// -z its turn about z is what the axis' least digits say.
ExactMatrix3 rotation_from_z_to(const ExactVector3& axis);

/// Rotation about z by an angle from a file, or one made of such.
ExactMatrix3 rotation_z_by(const Exact& angle);

}  // namespace treeline
