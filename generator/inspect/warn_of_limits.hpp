#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Reader of limits: code that is generated, with its bounds of rounding errors, or the loop of
/// `drive`.
enum class LimitUse { code, drive };

/// Names placeholders among the limits of joints that move in the scene, each kind once, at the
/// first such joint and with a count, and says what those who read the limit here take in its
/// place. Notes speeds that are stated but beyond those for which rounding bounds hold.
void warn_of_limits(const Robot& robot, const Scene& scene, LimitUse use, Diagnostics& diagnostics);

}  // namespace treeline
