#pragma once

#include "inspect/recognise_robot.hpp"

namespace treeline {

/// Says of what kind a robot with these limbs is and whether it floats, and why. `base` is the body
/// that the limbs start from.
void name_kind(const Robot& robot, const Body& base, RecognisedRobot& found);

}  // namespace treeline
