#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Numbers the joints of `robot` depth-first in file order (a floating base first), turns every
/// joint axis onto its link's z, lumps links behind fixed and locked joints, splits planar joints.
/// `scene` must have been read against `robot`.
Mechanism build_mechanism(const Robot& robot, const Scene& scene);

/// Moves what does not change the equations of motion from each link to its parent: of a revolute
/// link the matter that lies on the joint axis (mass, first moment along it, Sigma_zz), of a
/// prismatic link the second moment (base inertial parameters: Gautier & Khalil 1990).
void regroup_inertias(Mechanism& mechanism);

/// Turns and slides every link frame along its joint axis so that the constants of transforms,
/// inertias and points become sparse (after Khalil & Kleinfinger 1986).
void seat_frames(Mechanism& mechanism);

/// `build_mechanism`, `regroup_inertias`, `seat_frames`, and what then can be regrouped again.
Mechanism reduced_mechanism(const Robot& robot, const Scene& scene);

}  // namespace treeline
