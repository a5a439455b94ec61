#pragma once

#include "joint/joint_type_info.hpp"

namespace treeline {

/// Slides in the plane normal to its axis, and then turns about the axis. See `.convention`.
inline constexpr JointCoordinate kPlanarCoordinates[] = {{"x, m", CoordinateKind::displacement},
                                                         {"y, m", CoordinateKind::displacement},
                                                         {"theta, rad", CoordinateKind::angle}};
inline constexpr const char* kPlanarVelocities[] = {" x, m/s", " y, m/s", " theta, rad/s"};
inline constexpr JointTypeStep kPlanarSteps[] = {{{JointKind::prismatic}, StepAxis::x, "_x"},
                                                 {{JointKind::prismatic}, StepAxis::y, "_y"},
                                                 {{JointKind::revolute}, StepAxis::z, ""}};
inline constexpr JointTypeInfo kPlanarJoint{.type = JointType::planar,
                                            .name = "planar",
                                            .coordinates = kPlanarCoordinates,
                                            .velocities = kPlanarVelocities,
                                            .steps = kPlanarSteps,
                                            .convention =
                                                "A planar joint slides along x and y of its frame, "
                                                "turned by the smallest rotation that takes z to "
                                                "the axis, and then turns about the axis by theta; "
                                                "x and y are fixed in the parent."};

}  // namespace treeline
