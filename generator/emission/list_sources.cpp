#include "emission/list_sources.hpp"

#include "emission/controller_unit.hpp"

namespace treeline {

std::vector<Program> list_sources(const EmissionContext& context,
                                  std::span<const Program> programs) {
  std::vector<Program> sources(programs.begin(), programs.end());
  if (!context.controller) return sources;
  for (const Program* const program : context.controller->programs()) sources.push_back(*program);
  return sources;
}

}  // namespace treeline
