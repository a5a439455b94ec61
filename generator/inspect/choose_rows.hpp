#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// How many random states within the limits the choice rests on.
inline constexpr int kRowStates = 9;

/// Gives each of the points, which have all rows, those that their links can be moved in
/// independently of each other: first each by the joints of its own chain, base at rest, then all
/// of them together, translations before rotations. Some may be left without.
void choose_rows(const Robot& robot, const Scene& scene, std::vector<ScenePoint>& points);

}  // namespace treeline
