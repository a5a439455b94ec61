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

/// Takes the offsets that frames were turned by out of those angles whose sum with them would be
/// rounded too coarsely, and gives them back to the seats, where sines and cosines of q are turned
/// on by the theorem of addition: five operations a joint more. Two digits at a thousand rad.
/// `fastest`: none; `balanced`: of joints that their limits let go far; `best`: all.
void keep_angles(Mechanism& mechanism, Accuracy accuracy);

/// Whether inertias are regrouped, as is best, or left in full, for comparison.
enum class Inertias { regrouped, full };

/// `build_mechanism`, `regroup_inertias`, `seat_frames`, what then can be regrouped again, and
/// `keep_angles`.
Mechanism reduced_mechanism(const Robot& robot, const Scene& scene,
                            Inertias inertias = Inertias::regrouped);

}  // namespace treeline
