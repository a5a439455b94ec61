#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Fills in the report's risks: joints by which this robot loses digits in this scene. They are
/// found by the interpreter in double at states within the joints' limits, the same states in every
/// run. The report must contain its joints already.
///  - Inertia: M_ii (M^-1)_ii, the ratio of the inertia that a joint feels with the others locked
///  to
///    the one with the others free. It bounds the loss of a solve with M over joint i. The worst of
///    some states.
///  - Mass: what joints of very different inertias cost Lambda^-1 in any state, see
///    `find_mass_ratio`. If there are such joints, singularities are not searched.
///  - Singularity: the condition number of Lambda^-1, scaled to a unit diagonal, along each joint's
///    range with the other joints at rest in a few states, followed to its peak.
///  - Angle: ranges that exceed |q| <= 2e8 rad, beyond which sines are not accurate.
void inspect_risks(const Robot& robot, const Scene& scene, Report& report);

}  // namespace treeline
