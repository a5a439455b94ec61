#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Whether a function is about operational points.
bool needs_points(Function function);

/// Whether a function has an input for the scene's external forces.
bool takes_external_forces(Function function);

/// Whether a function inverts the mass matrix.
bool inverts_mass_matrix(Function function);

/// Chooses the functions where the scene lists none, and reports what the robot cannot do: nothing
/// moves, functions of points without points or that `damped` lacks, functions that invert a mass
/// matrix which is singular by its structure, more controlled rows than coordinates that move them,
/// names of joints that meet in one identifier.
void complete_scene(const SceneElement& top, const Robot& robot, Scene& scene);

}  // namespace treeline
