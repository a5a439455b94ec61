#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Reads the rotors of motors from the robot's `<transmission>` elements into `Joint::rotor`: the
/// gear ratio from `<drake:gear_ratio value>` or the text of `<mechanicalReduction>`, the inertia
/// (kg m^2 about the motor's axis) from `<drake:rotor_inertia value>`,
/// `<rotorInertia>` or `<motorInertia>`. A `<transmission>` of
/// several joints or motors couples them and is passed over, with a warning where it has an
/// inertia.
void read_rotors(const UrdfElement& robot, std::vector<Joint>& joints);

/// Kinetic energy of the rotor is armature qd^2 / 2: inertia times the square of the gear ratio,
/// kg m^2 (kg for a sliding joint). 0 where the file states no inertia.
double armature_of(const Joint& joint);

}  // namespace treeline
