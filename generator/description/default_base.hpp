#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Kind of the base where no scene states it: fixed; floating where the file says so, or where no
/// joint moves and there is mass, as of drones and single bodies, which could not move at all
/// otherwise.
Base default_base(const Robot& robot);

/// Why `default_base` is floating: `the file says so` or `no joint moves`.
const char* why_floating(const Robot& robot);

}  // namespace treeline
