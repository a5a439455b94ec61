#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Fills the report's risks: the joints over which this robot in this scene loses digits, from the
/// interpreter in double at states within the joints' limits, the same ones in every run. Needs the
/// report's joints.
///  - Inertia: M_ii (M^-1)_ii, by how much a joint feels heavier with the others locked than with
///    them free, bounds what solving with M loses over joint i; worst of some states.
///  - Mass: what joints of very different inertias cost Lambda^-1 in any state, see
///    `find_mass_ratio`; from this on singularities are not looked for.
///  - Singularity: the condition of Lambda^-1, scaled to a unit diagonal, along each joint's range
///    with the others at rest in a few states, climbed to its peak.
///  - Angle: ranges that leave |q| <= 2e8 rad, where sines are no longer accurate.
void inspect_risks(const Robot& robot, const Scene& scene, Report& report);

}  // namespace treeline
