#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Appends what rotors, friction and springs of joints add to the equations of motion, as contracts
/// tell it.
void append_drive_notes(const Robot& robot, const Scene& scene, std::vector<std::string>& notes);

/// Appends what the entries of `payload`, `parameters`, `tool`, `tool_orientation`, `contact` and
/// `active` belong to, and what the files say of them.
void append_input_notes(const Scene& scene, const Mechanism& mechanism,
                        std::vector<std::string>& notes);

/// Says for the contract which parameter each column of the regressors belongs to, if the scene
/// asks for regressors.
void append_regressor_notes(const Scene& scene, const Mechanism& mechanism,
                            std::vector<std::string>& notes);

}  // namespace treeline
