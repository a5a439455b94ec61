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
/// coordinates that move them, names of joints that meet in one identifier. Faults of the functions
/// are told of `list`, where they are listed.
void complete_scene(const SceneElement& top, const SceneElement& list, const Robot& robot,
                    bool listed, Scene& scene);

/// Warns of forces, contacts, constraints and passive joints that none of the functions takes.
void warn_of_unused(const SceneElement& top, const Scene& scene);

/// Why a scene that holds no rows does not permit supported_control_torque.
const char* why_unsupported(const Scene& scene);

/// Functions that `limited_control_torque` calls.
std::vector<Function> functions_of_limits(const Scene& scene);

/// Adds to functions that the scene did not list those that `limited_control_torque` calls.
void add_functions_of_limits(const Robot& robot, Scene& scene);

/// Reports what limits of torques and friction lack.
void check_limits(const SceneElement& top, const Robot& robot, const Scene& scene);

/// Reports what cannot be combined with a task of the centre of mass; false where it does.
bool check_center_of_mass(const SceneElement& top, const Robot& robot, const Scene& scene);

/// Reports hands that cannot hold what the scene says: fewer coordinates than the grasps have rows,
/// grasps at one place, on a line or in a plane where the virtual linkage needs more.
void check_objects(const SceneElement& top, const Robot& robot, const Scene& scene);

}  // namespace treeline
