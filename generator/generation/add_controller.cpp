#include "generation/add_controller.hpp"

#include <memory>

#include "emission/print_controller.hpp"
#include "generation/compose_controller.hpp"

namespace treeline {

void add_controller(const Robot& robot, const Scene& scene, EmissionContext& context,
                    Generation& generation) {
  generation.controller = std::make_shared<const ControllerUnit>(
      compose_controller(robot, scene, generation.mechanism));
  context.controller = generation.controller;
  generation.laws = print_reference_laws(context, *generation.controller);
}

}  // namespace treeline
