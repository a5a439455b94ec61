#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/repair_urdf.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Fills in which impossible inertias affect the motion, the possible inertias nearest to them, and
/// which bodies are flat. The report must contain its links already.
void inspect_inertias(const Robot& robot, const Scene& scene, Report& report);

/// Returns the inertias to repair, of the links whose faults affect the motion.
std::vector<InertiaRepair> list_repairs(const Robot& robot, const Report& report);

}  // namespace treeline
