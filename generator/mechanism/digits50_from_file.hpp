#pragma once

#include "description/robot.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Pose from a file's doubles, with 50 digits. Quarter turns are exact, see
/// `sin_cos_of_file_angle`.
Digits50Pose digits50_pose(const Pose& pose);

/// Inertia of a body about the origin of its link's frame. The second moment about the centre of
/// mass is Sigma = tr(J)/2 1 - J, where J is the rotational inertia there.
Inertia digits50_inertia(const Inertial& body);

/// Radius of gyration about the frame's origin, sqrt(tr(Sigma) / m), in m. 0 for values that no
/// body can have.
Digits50 radius_of_gyration(const Inertia& inertia);

/// Shortest rotation that takes z to the unit vector `axis`; half a turn about x for -z. Near -z
/// the rotation about z depends on the axis' last digits.
Digits50Matrix3 rotation_from_z_to(const Digits50Vector3& axis);

/// Rotation about z by an angle (rad) from a file, or by a multiple or sum of such angles.
Digits50Matrix3 rotation_z_by(const Digits50& angle);

}  // namespace treeline
