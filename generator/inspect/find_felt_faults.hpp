#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Finds impossible inertias on which the motion depends. A link is one of them if no choice of
/// possible bodies, of whatever mass, moves like the robot with this link unchanged and every other
/// impossible link repaired. Other faults do not matter: the link is fixed to a body that makes up
/// for it, or is at rest, or is impossible only in what regrouping moves to bodies that can absorb
/// it. `faulty` are indices of links with impossible second moments; returns some of them.
std::vector<int> find_felt_faults(const Robot& robot, const Scene& scene,
                                  const std::vector<int>& faulty);

}  // namespace treeline
