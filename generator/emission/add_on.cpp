#include "emission/add_on.hpp"

#include <algorithm>

#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/descriptions.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"

namespace treeline {

bool always(const Contents& /*contents*/) {
  return true;
}

bool wants_damping(const Contents& contents) {
  return !contents.context.effective_mass_limits.empty();
}

bool wants_limits(const Contents& contents) {
  return contents.context.limits.has_value();
}

bool wants_batch(const Contents& contents) {
  return !contents.batch.empty();
}

bool wants_batch_limits(const Contents& contents) {
  return wants_limits(contents) && wants_batch(contents);
}

bool wants_controller(const Contents& contents) {
  return contents.context.controller != nullptr;
}

bool wants_ground(const Contents& contents) {
  return contents.context.ground != nullptr;
}

bool wants_selftest(const Contents& contents) {
  return contents.context.selftest != nullptr;
}

bool wants_loops(const Contents& contents) {
  return count_loops(contents.all) > 0;
}

bool wants_lanes(const Contents& contents) {
  return std::any_of(contents.all.begin(), contents.all.end(), uses_lanes);
}

bool wants_registers(const Contents& contents) {
  const bool eights = wants_limits(contents) && !contents.context.misra;
  return eights || wants_endings(contents);
}

bool wants_laws(const Contents& contents) {
  return wants_damping(contents) || wants_limits(contents) || wants_controller(contents) ||
         wants_ground(contents);
}

bool wants_sines(const Contents& contents) {
  const auto takes_some = [](const auto& programs) {
    return std::any_of(programs.begin(), programs.end(), uses_trigonometry);
  };
  return wants_laws(contents) || wants_loops(contents) || takes_some(contents.batch) ||
         takes_some(contents.all);
}

std::vector<GeneratedFile> join_files(std::initializer_list<std::vector<GeneratedFile>> lists) {
  std::vector<GeneratedFile> files;
  for (const auto& list : lists) files.insert(files.end(), list.begin(), list.end());
  return files;
}

std::vector<GeneratedFile> print_registers(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const Adaptation own = make_adaptation(context, header_name(context, context.name));
  return {{header_name(context, "registers"), adapt(templates::kRegisters, own)}};
}

std::vector<GeneratedFile> print_square_root_of(const Contents& contents) {
  return {print_square_root(contents.context)};
}

std::vector<GeneratedFile> print_sines_by_pointers(const Contents& contents) {
  return {print_sin_cos(contents.context)};
}

}  // namespace treeline
