#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Appends what rotors, friction and springs of joints add to the equations of motion, as contracts
/// tell it.
void append_drive_notes(const Robot& robot, const Scene& scene, std::vector<std::string>& notes);

}  // namespace treeline
