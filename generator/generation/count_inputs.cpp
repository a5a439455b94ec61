#include "choice/function_mechanisms.hpp"
#include "description/scene_inputs.hpp"
#include "generation/compose.hpp"
#include "passes/count_operations.hpp"

namespace treeline {

std::map<std::string, std::vector<EmissionContext::InputCost>> count_inputs(
    const Robot& robot, const Scene& scene, const std::vector<GeneratedFunction>& functions) {
  std::map<std::string, std::vector<EmissionContext::InputCost>> costs;
  for (const QuantityInfo& row : kQuantities) {
    if (!is_of_model(row.quantity) || !has_input(scene, row.quantity)) continue;
    Scene without = scene;
    remove_input(row.quantity, without);
    FunctionMechanisms mechanisms(robot, without);
    for (const GeneratedFunction& generated : functions) {
      const Function function = generated.function;
      if (!takes_input(scene, function, row.quantity)) continue;
      const GeneratedFunction other =
          generate_function(mechanisms.of(function), function, route_options(scene));
      costs[generated.program.name].push_back(
          {row.symbol,
           count_operations(generated.program).flops() - count_operations(other.program).flops()});
    }
  }
  return costs;
}

}  // namespace treeline
