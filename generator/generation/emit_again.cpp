#include <utility>

#include "generation/describe_scene.hpp"
#include "generation/generate_code.hpp"
#include "generation/without_callers.hpp"

namespace treeline {

std::vector<GeneratedFile> emit_to_try(const Robot& robot, const Scene& scene,
                                       const Mechanism& mechanism,
                                       const GeneratedFunction& function,
                                       Diagnostics& diagnostics) {
  Scene alone = without_callers(scene);
  alone.functions = {function.function};
  if (function.batch == 0) alone.batch = 0;
  const std::vector<Program> programs{function.program};
  return emit(describe_scene(robot, alone, mechanism), programs, diagnostics,
              function.batch > 0 ? programs : std::vector<Program>{});
}

void emit_with_selftest(std::shared_ptr<const SelftestFacts> facts, Generation& generation) {
  EmissionContext context = *generation.context;
  context.selftest = std::move(facts);
  Diagnostics told;  // the first time
  const auto programs = programs_of(generation.functions), batch = programs_of(generation.batch);
  generation.files = emit(context, programs, told, batch);
  generation.sources = list_sources({context, programs, batch});
  generation.context = std::make_shared<const EmissionContext>(std::move(context));
}

}  // namespace treeline
