#pragma once

#include "mechanism/mechanism.hpp"

namespace treeline {

/// Number of components that are not zero.
int nonzeros(const Digits50Vector3& v);

/// Operations that a constant pose costs in the recursions.
int pose_cost(const Digits50Pose& pose);

/// Operations that a link's placement and the offset of its angle cost in the recursions.
int link_cost(const MovingLink& link);

/// Whether the z axes of both frames are parallel.
bool is_parallel(const Digits50Matrix3& R);

/// Decomposes R = Rz(a) Rx(alpha) Rz(b) and returns b, or a + b if alpha is a multiple of pi.
Digits50 right_turn(const Digits50Matrix3& R);

/// Moves the rotation about z at the end of a revolute link's placement to the joint angle, if that
/// is cheaper.
void absorb_turn(MovingLink& link, const Resolution& resolution, Change* change);

/// Cost of the link after `absorb_turn`, if its placement were this one. It takes functions of
/// angles only where the joint has an offset already: in 50 digits they are most of the work.
int absorbed_cost(const MovingLink& link, const Digits50Pose& placement,
                  const Resolution& resolution);

}  // namespace treeline
