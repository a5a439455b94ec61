#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// The scene's `controller`: laws, period, gains and limits of the controller to emit. Errors: no
/// law, a law twice, numbers that no controller can have, frequencies that the period cannot
/// follow, limits of a joint that is unknown or has no coordinate of its own.
void read_controller(const SceneElement& element, const Robot& robot, Scene& scene);

/// What keeps a joint from being driven as one number by a motor: "joint "wrist" is passive"; empty
/// where all joints can be.
std::string find_unfit_joint(const Robot& robot, const Scene& scene);

/// Functions that the scene's controller contains beside those that the scene asks for; none
/// without a controller.
std::vector<Function> list_controller_functions(const Scene& scene);

/// Reports as an error what of the robot and the rest of the scene does not permit the controller
/// that is asked for. Every coordinate needs a motor and a number of its own: no floating base, no
/// ball joint, nothing passive, no closed loop; and limits, see `check_controller_limits`. Laws of
/// tasks need operational points and the inverse of the mass matrix: `singular` names what has no
/// mass beyond it, if anything.
void check_controller(const SceneElement& top, const Robot& robot, const std::string& singular,
                      const Scene& scene);

}  // namespace treeline
