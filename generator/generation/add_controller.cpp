#include "generation/add_controller.hpp"

#include <memory>
#include <utility>

#include "emission/cpp/print_controller.hpp"
#include "emission/cpp/print_runtime.hpp"
#include "generation/compose_controller.hpp"

namespace treeline {

void add_controller(const Robot& robot, const Scene& scene, EmissionContext& context,
                    Generation& generation) {
  generation.controller = std::make_shared<const ControllerUnit>(
      compose_controller(robot, scene, generation.mechanism));
  context.controller = generation.controller;
  EmissionContext plain = context;
  plain.misra = false;
  generation.laws = cpp::print_controller(plain, *generation.controller);
  for (GeneratedFile& file : cpp::print_controller_headers(plain)) {
    generation.laws.push_back(std::move(file));
  }
}

}  // namespace treeline
