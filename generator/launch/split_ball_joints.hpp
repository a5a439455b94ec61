#pragma once

#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Puts three hinges about x, y and z in place of each ball joint NAME: NAME.x, NAME.y and NAME.z,
/// with massless links of the first two names between. What is driven then has no quaternion but
/// the base's: goals, sliders and handles are those of hinges. The motion is the ball joint's but
/// where NAME.y comes near a quarter turn; it is kept within 80 degrees. A note says so.
void split_ball_joints(Robot& robot, Scene& scene, Diagnostics& diagnostics);

/// Text of the URDF with its ball joints split, for display; unchanged if there are none.
std::string split_ball_joints(const std::string& urdf_text);

}  // namespace treeline
