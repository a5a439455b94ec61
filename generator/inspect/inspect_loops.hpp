#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Fills in the report's loops, and adds their singular poses to its risks (Gosselin & Angeles
/// 1990). Each joint of a loop, or each motor if the scene calls joints passive, is led through its
/// range from some closed poses, the same ones in every run, while the loops stay closed. Named are
/// joints on whose way
///  - rows of the loops depend on each other that elsewhere do not: the loop gains a freedom and
///    may leave its path there (a parallelogram that is folded flat);
///  - the motors lose hold: passive joints can move while all motors are at rest (a slider-crank
///    driven by its slider, at the dead point).
/// Does nothing if the scene has no constraints between links and no couplings. The report must
/// contain its joints already.
void inspect_loops(const Robot& robot, const Scene& scene, Report& report);

}  // namespace treeline
