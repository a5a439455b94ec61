#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Fills the report's centre of mass and mass matrix, from the interpreter at the neutral pose.
void inspect_masses(const Robot& robot, const Scene& scene, Report& report);

}  // namespace treeline
