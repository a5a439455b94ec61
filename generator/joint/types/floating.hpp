#pragma once

#include "joint/joint_type_info.hpp"

namespace treeline {

/// Moves freely. Position and quaternion are those of the link in the joint's frame; the velocities
/// are those of the link's origin and its angular velocity, in the link's axes.
inline constexpr JointCoordinate kFloatingCoordinates[] = {
    {"position x, m", CoordinateKind::displacement},
    {"position y, m", CoordinateKind::displacement},
    {"position z, m", CoordinateKind::displacement},
    {"quaternion x", CoordinateKind::quaternion_xyz},
    {"quaternion y", CoordinateKind::quaternion_xyz},
    {"quaternion z", CoordinateKind::quaternion_xyz},
    {"quaternion w", CoordinateKind::quaternion_w}};
inline constexpr const char* kFloatingVelocities[] = {" linear x, m/s",    " linear y, m/s",
                                                      " linear z, m/s",    " angular x, rad/s",
                                                      " angular y, rad/s", " angular z, rad/s"};
inline constexpr JointTypeStep kFloatingSteps[] = {{{JointKind::floating}, StepAxis::z, ""}};
inline constexpr JointTypeInfo kFloatingJoint{
    .type = JointType::floating,
    .name = "floating",
    .has_axis = false,
    .coordinates = kFloatingCoordinates,
    .velocities = kFloatingVelocities,
    .steps = kFloatingSteps,
    .convention =
        "Of a floating joint q is position and quaternion (x y z w, of a length from 1e-7 to "
        "1e150, in float to 1e18; 0 turns by nothing) in the parent's frame, qd its linear and "
        "angular velocity in the moving link's axes, tau force and moment in those axes; qdd is "
        "the "
        "derivative of qd, component by component."};

}  // namespace treeline
