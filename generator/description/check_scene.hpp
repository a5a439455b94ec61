#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Whether robot and scene have what the function is about.
bool permits(const Robot& robot, const Scene& scene, Function function);

/// All functions that a scene has which lists none: those of joints, of its points, contacts,
/// objects and constraints. `supported_control_torque` of a robot that merely floats is not among
/// them.
std::vector<Function> default_functions(const Robot& robot, const Scene& scene);

/// Chooses the functions where none are `listed`, without those that invert a mass matrix which
/// cannot be inverted for want of any mass (`leave_out_singular` says so, and finds other reasons);
/// and reports what the robot cannot do: nothing moves, functions of points without points or that
/// `damped` lacks, functions listed that invert such a matrix, more controlled rows than
/// coordinates that move them, names of joints that meet in one identifier.
void complete_scene(const SceneElement& top, const Robot& robot, bool listed, Scene& scene);

/// Warns of forces, contacts, constraints and passive joints that none of the functions takes.
void warn_of_unused(const SceneElement& top, const Scene& scene);

}  // namespace treeline
