#pragma once

#include "carry_plan.hpp"

namespace treeline::experiments {

/// Torques of one robot that knows the plan and its own joints, and nothing of the other one: it
/// sees the object by its own hand, and gives its share of the object's force and of the internal
/// forces besides moving itself. So it controls its inertia augmented by its share of the object
/// (Chang 7.3.1; Khatib et al. 1996). `q`, `qd`, `qdd_0` are its own; `internal` are the internal
/// forces commanded to both.
void control_share(int robot, const CarryPlan& plan, const Wanted& wanted,
                   const double (&internal)[6], const double (&q)[kJoints],
                   const double (&qd)[kJoints], const double (&qdd_0)[kJoints],
                   double (&tau)[kJoints]);

}  // namespace treeline::experiments
