#include "generation/add_ground.hpp"

#include <memory>
#include <utility>

#include "generation/compose_ground.hpp"

namespace treeline {

void add_ground(const Robot& robot, const Scene& scene, EmissionContext& context,
                Diagnostics& diagnostics) {
  GroundUnit unit = compose_ground(robot, scene);
  if (unit.groups.empty()) {
    diagnostics.add({Severity::error, robot.file, 0, "collision",
                     "no link that moves has a shape that could touch the ground",
                     "Give links a <collision>, or leave out `step` of the scene's ground."});
    return;
  }
  context.ground = std::make_shared<const GroundUnit>(std::move(unit));
}

}  // namespace treeline
