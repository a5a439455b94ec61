#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Number of random states within the limits on which the choice is based.
inline constexpr int kRowStates = 9;

/// Chooses the rows of each of the points, which come with all rows: those that their links can
/// move in independently of each other. Each point is first considered alone, with the joints of
/// its own chain and the base at rest; then all of them together, translations before rotations.
/// Some points may keep no row.
void choose_rows(const Robot& robot, const Scene& scene, std::vector<ScenePoint>& points);

/// Keeps, of the points' rows, those that can be moved independently of each other in half of some
/// random states, translations before rotations.
void keep_independent_rows(const Robot& robot, const Scene& scene, std::vector<ScenePoint>& points);

}  // namespace treeline
