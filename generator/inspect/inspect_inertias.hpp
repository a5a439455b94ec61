#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/repair_urdf.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Fills in which impossible inertias the motion can feel, what possible ones are nearest to them,
/// and which bodies are flat. Needs the report's links.
void inspect_inertias(const Robot& robot, const Scene& scene, Report& report);

/// The inertias to repair, of the links that the motion can feel.
std::vector<InertiaRepair> list_repairs(const Robot& robot, const Report& report);

}  // namespace treeline
