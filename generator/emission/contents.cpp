#include "emission/contents.hpp"

#include "emission/controller_unit.hpp"

namespace treeline {

Contents::Contents(const EmissionContext& facts, std::span<const Program> asked,
                   std::span<const Program> in_batches)
    : context(facts), programs(asked), batch(in_batches), all(asked.begin(), asked.end()) {
  if (!context.controller) return;
  for (const Program* const program : context.controller->programs()) all.push_back(*program);
}

}  // namespace treeline
