#include "emission/list_sources.hpp"

#include "emission/backend.hpp"
#include "emission/describe_program.hpp"
#include "passes/count_operations.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

/// Bytes of code that an operation takes with its loads and stores, and of the cache for code, at
/// most: x86-64 and AArch64 as on PCs; cores of microcontrollers that have a cache have 16 KB.
struct CodeModel {
  int bytes_of_operation;
  int cache;
};

CodeModel model_of(std::string_view name) {
  const Target* const target = find_target(name);
  const bool small = target != nullptr && !target->contracts;  // as microcontrollers do
  return small ? CodeModel{5, 16384} : CodeModel{9, 32768};
}

bool is_larger_than_a_cache(std::string_view target, const Program& program) {
  const CodeModel model = model_of(target);
  return count_operations(program).flops() * model.bytes_of_operation > model.cache;
}

}  // namespace

OwnFlags choose_own_flags(Optimize optimize, std::string_view target, const Program& program,
                          bool batch) {
  OwnFlags flags{false, is_long(program), is_huge(program)};
  if (flags.is_huge) return flags;
  flags.is_small = optimize == Optimize::size;
  if (optimize != Optimize::balanced || batch) return flags;
  flags.is_small = program.small_code.value_or(is_larger_than_a_cache(target, program));
  return flags;
}

std::vector<Source> list_sources(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const Backend& backend = backend_of(context.language);
  const bool is_small = context.optimize == Optimize::size;
  const bool joins = backend.joins_loops && count_loops(contents.all) > 1;
  std::vector<Source> sources;
  const auto add = [&](const std::string& stem, Source::Of of, OwnFlags flags) -> Source& {
    return sources.emplace_back(Source{stem + std::string(backend.source), of, flags});
  };
  const auto add_function = [&](const Program& program, Source::Of of) {
    const bool batch = of == Source::Of::batch;
    const OwnFlags flags = choose_own_flags(context.optimize, context.target, program, batch);
    add((batch ? "batch_" : "") + program.name, of, flags).is_joined = joins && program.loops;
  };
  for (const Program& program : contents.all) {
    const bool asked = sources.size() < contents.programs.size();
    add_function(program, asked ? Source::Of::function : Source::Of::dynamics);
  }
  for (const Program& program : contents.batch) add_function(program, Source::Of::batch);
  for (const AddOn& add_on : backend.add_ons) {
    if (add_on.source == nullptr || !add_on.wants(contents)) continue;
    add(add_on.source, add_on.of, {add_on.computes && is_small});
  }
  if (joins) add(context.name + "_loops", Source::Of::joined, {is_small});
  return sources;
}

}  // namespace treeline
