#pragma once

#include <map>
#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// The coordinates that move something: for each the joint that owns it (index into Robot::joints,
/// or `kFloatingBase`) with its degrees of freedom.
using Freedoms = std::map<int, int>;
inline constexpr int kFloatingBase = -1;

/// Sum over the owners: entries of qd.
int count(const Freedoms& freedoms);

/// All coordinates of the robot in the scene: fixed, locked and mimic joints own none.
Freedoms find_freedoms(const Robot& robot, const Scene& scene);

/// Coordinates that move a link in the world. A mimic joint counts as the joint that it follows.
Freedoms find_freedoms_of_link(const Robot& robot, const Scene& scene, const std::string& link);

/// Whether some joint between two links moves.
bool moves_against(const Robot& robot, const Scene& scene, const std::string& link,
                   const std::string& other);

}  // namespace treeline
