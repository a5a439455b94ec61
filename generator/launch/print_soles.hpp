#pragma once

#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Members of a driven robot that stands on a ground: the points of its feet that may touch it, in
/// the frames of `constraints` to the world, and the ground's friction.
std::string print_soles(const Robot& robot, const Scene& ground, const Scene& control);

}  // namespace treeline
