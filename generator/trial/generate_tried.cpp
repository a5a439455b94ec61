#include "trial/generate_tried.hpp"

#include <utility>

#include "trial/retry_routes.hpp"

namespace treeline {

std::optional<TriedGeneration> generate_tried(const Robot& robot, const Scene& scene,
                                              const Provenance& provenance,
                                              const TriedOptions& options,
                                              Diagnostics& diagnostics) {
  auto chosen = choose_for_language(robot, scene, options.choices, options.tell, diagnostics);
  if (!chosen) return std::nullopt;
  if (options.tell) options.tell("and trying the functions");
  TriedFunctions tried = retry_routes(robot, scene, std::move(*chosen), diagnostics);
  if (!tried.failed.empty() && options.failing == Failing::left_out) {
    leave_out_failed(tried, list_files(provenance), diagnostics);
    if (tried.chosen.functions.empty()) {
      return TriedGeneration{{std::move(tried.chosen), std::move(tried.scene)},
                             std::move(tried.failed)};
    }
  }
  auto generation = emit_chosen(robot, tried.scene, provenance, std::move(tried.chosen),
                                options.tell, diagnostics);
  if (!generation) return std::nullopt;
  return TriedGeneration{std::move(*generation), std::move(tried.failed)};
}

}  // namespace treeline
