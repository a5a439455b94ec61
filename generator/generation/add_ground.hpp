#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emission_context.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Composes the step on the ground that the scene asks for, and gives it to the context that prints
/// it. Errors: nothing that moves could touch the ground.
void add_ground(const Robot& robot, const Scene& scene, EmissionContext& context,
                Diagnostics& diagnostics);

}  // namespace treeline
