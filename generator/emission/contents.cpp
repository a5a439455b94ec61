#include "emission/contents.hpp"

#include "emission/controller_unit.hpp"
#include "emission/ground_unit.hpp"

namespace treeline {

Contents::Contents(const EmissionContext& facts, std::span<const Program> asked,
                   std::span<const Program> in_batches)
    : context(facts), programs(asked), batch(in_batches), all(asked.begin(), asked.end()) {
  const auto add = [&](const auto& unit) {
    if (!unit) return;
    for (const Program* const program : unit->programs()) all.push_back(*program);
  };
  add(context.controller);
  add(context.ground);
}

}  // namespace treeline
