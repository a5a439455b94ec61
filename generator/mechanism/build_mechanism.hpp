#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Builds the mechanism of `robot`: numbers the joints depth-first in file order (a floating base
/// first), turns each link's z onto its joint axis, lumps links behind fixed and locked joints into
/// their parents, and splits joints of several axes into their steps. `scene` must have been read
/// for this `robot`.
Mechanism build_mechanism(const Robot& robot, const Scene& scene);

/// Moves inertial parameters that do not change the equations of motion from each link to its
/// parent. For a revolute link this is the matter on the joint axis (mass, first moment along the
/// axis, Sigma_zz), for a ball joint the mass at its centre, for a prismatic link the second moment
/// (base inertial parameters: Gautier & Khalil 1990).
void regroup_inertias(Mechanism& mechanism);

/// Turns and slides every link frame about and along its joint axis so that the constants of
/// transforms, inertias and points become sparse (after Khalil & Kleinfinger 1986).
void place_frames(Mechanism& mechanism);

/// Removes angle offsets that would make q + offset be rounded too coarsely. The offset returns to
/// the placement of the joint; sines and cosines of q are then rotated by the addition theorems,
/// which costs five operations per joint. This saves two digits at 1000 rad. With `fastest` no
/// offset is removed, with `balanced` those of joints whose limits are wide, with `best` all.
void keep_angles(Mechanism& mechanism, Accuracy accuracy);

/// Largest angle of a link that turns by one, as the limits of the joint permit that it is or
/// follows, including its offset; rad.
double largest_angle(const Mechanism& mechanism, const MovingLink& link);

/// Builds the mechanism of `robot` and leaves the links' frames where the URDF has them, but for
/// rotations that take z to the joint axes: `build_mechanism` and `keep_angles`.
Mechanism mechanism_in_frames_of_files(const Robot& robot, const Scene& scene);

/// Whether inertias are regrouped, which is the default, or left in full for comparison.
enum class Inertias { regrouped, full };

/// Builds the mechanism of `robot` and reduces it: `build_mechanism`, `regroup_inertias`,
/// `place_frames`, another regrouping of what then has become possible, and `keep_angles`.
Mechanism reduced_mechanism(const Robot& robot, const Scene& scene,
                            Inertias inertias = Inertias::regrouped);

}  // namespace treeline
