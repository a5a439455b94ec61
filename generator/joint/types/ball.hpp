#pragma once

#include "joint/joint_type_info.hpp"

namespace treeline {

/// Turns about a point. The quaternion is that of the link in the joint's frame; the velocities are
/// the angular velocity in the link's axes. Its three steps are the axes of the link, not angles,
/// so that no pose is singular. The LDL^T of the three-by-three inertia at the joint, which a joint
/// of three freedoms would need, then is the elimination of one axis after the other.
inline constexpr JointCoordinate kBallCoordinates[] = {
    {"quaternion x", CoordinateKind::quaternion_xyz},
    {"quaternion y", CoordinateKind::quaternion_xyz},
    {"quaternion z", CoordinateKind::quaternion_xyz},
    {"quaternion w", CoordinateKind::quaternion_w}};
inline constexpr const char* kBallVelocities[] = {" angular x, rad/s", " angular y, rad/s",
                                                  " angular z, rad/s"};
inline constexpr JointTypeStep kBallSteps[] = {
    {{JointKind::revolute, BallAxis::x}, StepAxis::x, "_x"},
    {{JointKind::revolute, BallAxis::y}, StepAxis::y, "_y"},
    {{JointKind::revolute, BallAxis::z}, StepAxis::z, ""}};
inline constexpr JointTypeInfo kBallJoint{
    .type = JointType::ball,
    .name = "ball",
    .other_name = "spherical",
    .is_standard = false,
    .has_axis = false,
    .coordinates = kBallCoordinates,
    .velocities = kBallVelocities,
    .steps = kBallSteps,
    .convention =
        "Of a ball joint q is a quaternion (x y z w, of a length from 1e-7 to 1e150, in float to "
        "1e18; 0 turns by nothing), that of the link in the joint's frame, qd its angular velocity "
        "and tau the moment, both in the moving link's axes; qdd is the derivative of qd, "
        "component "
        "by component."};

}  // namespace treeline
