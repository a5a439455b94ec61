#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Removes the functions that need M^-1 from the scene if M is singular in every pose. One warning
/// names the directions without inertia and a cure. Functions that were requested by name
/// (`listed`: those of the scene are), including `damped`, are not removed; an error with the same
/// content is reported for them.
void leave_out_singular(const Robot& robot, Scene& scene, bool listed, Diagnostics& diagnostics);

/// Whether joint forces determine accelerations: an error with the same content says that M is
/// singular in every pose.
bool has_accelerations(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
