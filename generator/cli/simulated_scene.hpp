#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Reports as errors what of a scene would hold or load a robot and has no place in a motion
/// through time: constraints, loops of the robot's file, couplings, objects.
void refuse_unheld(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

/// Notes what of a scene `simulate` leaves out: obstacles; and where there are joint forces, motors
/// that joints do not have, and largest torques.
void note_unsimulated(const Scene& scene, const SceneSurroundings& surroundings,
                      bool has_joint_forces, Diagnostics& diagnostics);

}  // namespace treeline
