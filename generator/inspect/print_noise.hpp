#pragma once

#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Prints a line for each number of the files, and for each relation between frames, that is taken
/// as exact, with its place and the difference; also what `noise:` could change beyond that.
std::string print_noise(const Robot& robot, const Scene& scene);

}  // namespace treeline
