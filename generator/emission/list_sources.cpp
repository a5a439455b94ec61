#include "emission/list_sources.hpp"

#include <algorithm>

#include "emission/controller_unit.hpp"
#include "emission/describe_program.hpp"

namespace treeline {

std::vector<Program> list_sources(const EmissionContext& context,
                                  std::span<const Program> programs) {
  std::vector<Program> sources(programs.begin(), programs.end());
  if (!context.controller) return sources;
  for (const Program* const program : context.controller->programs()) sources.push_back(*program);
  return sources;
}

bool has_loops(const EmissionContext& context, std::span<const Program> programs) {
  if (has_loops(programs)) return true;
  if (!context.controller) return false;
  const auto own = context.controller->programs();
  return std::any_of(own.begin(), own.end(),
                     [](const Program* program) { return program->loops != nullptr; });
}

}  // namespace treeline
