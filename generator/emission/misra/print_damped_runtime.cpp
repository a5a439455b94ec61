#include "emission/misra/print_damped_runtime.hpp"

#include "emission/fill_template.hpp"
#include "emission/misra/templates.hpp"
#include "emission/print_damped_steps.hpp"
#include "emission/print_square_root.hpp"

namespace treeline::misra {

std::vector<GeneratedFile> print_damped_runtime(const EmissionContext& context) {
  return {{"damped_solve.hpp", fill_template(templates::kDampedSolve,
                                             {{"name", context.name},
                                              {"real", number_type(context)},
                                              {"rows", std::to_string(context.task_rows)},
                                              {"velocities", std::to_string(context.velocities)},
                                              {"steps", print_damped_steps(context)}})},
          print_square_root(context)};
}

}  // namespace treeline::misra
