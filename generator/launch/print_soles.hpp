#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"

namespace treeline {

/// Whether a held link, with all that is fixed to it, has a point among `touches` that may touch
/// the ground.
bool has_sole(const Robot& robot, const std::string& link, const std::vector<SceneTouch>& touches);

/// Members of a driven robot that stands on a ground: the points of its feet that may touch it, in
/// the frames of `constraints` to the world, and the ground's friction.
std::string print_soles(const Robot& robot, const Scene& ground, const Scene& control);

}  // namespace treeline
