#pragma once

#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A line for each number of the files, and each relation between frames, that is taken as exact,
/// with the place and by how much it differs; and what `noise:` could take beside.
std::string print_noise(const Robot& robot, const Scene& scene);

}  // namespace treeline
