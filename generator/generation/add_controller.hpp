#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emission_context.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Composes the controller that the scene asks for, and gives it to the context that prints it. Its
/// laws as `profile: plain` has them are kept in `Generation::laws`.
void add_controller(const Robot& robot, const Scene& scene, EmissionContext& context,
                    Generation& generation);

}  // namespace treeline
