#include "generation/warn_of_speed_rise.hpp"

#include <fmt/format.h>

#include "emission/controller_unit.hpp"

namespace treeline {

void warn_of_speed_rise(const Scene& scene, const Generation& generation,
                        Diagnostics& diagnostics) {
  if (!generation.controller || !scene.controller) return;
  const double asked = scene.controller->speed_rise;
  const double emitted = generation.controller->settings.speed_rise;
  if (asked == SceneController{}.speed_rise || !(emitted > asked)) return;
  diagnostics.add(
      {Severity::warning, scene.file, 0, "controller/speed_rise",
       fmt::format("{} s is asked for, and {} s is emitted: joints that rise to their limits of "
                   "speed sooner take more than half of the torque that gravity leaves the motors",
                   asked, emitted),
       fmt::format("write speed_rise: {}, or lower the limits of speed (key limits)", emitted)});
}

}  // namespace treeline
