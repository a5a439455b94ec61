#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Of links whose inertias no body has, those that the motion can feel: no choice of possible
/// bodies, of whatever mass, moves like the robot with this link as it is and every other
/// impossible link repaired. Others hide: fixed to a body that is possible with them, at rest, or
/// impossible only in what regrouping moves to bodies that can bear it. Indices of links; `faulty`
/// are those whose second moments are negative.
std::vector<int> find_felt_faults(const Robot& robot, const Scene& scene,
                                  const std::vector<int>& faulty);

}  // namespace treeline
