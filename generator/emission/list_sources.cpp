#include "emission/list_sources.hpp"

#include "emission/backend.hpp"
#include "emission/comment.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/list_source_holes.hpp"
#include "emission/print_target.hpp"

namespace treeline {

OwnFlags choose_own_flags(Optimize optimize, const Program& program) {
  const bool huge = is_huge(program);
  return {optimize == Optimize::size && !huge, is_long(program), huge};
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
    const OwnFlags flags = choose_own_flags(context.optimize, program);
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

std::map<std::string, std::string> list_source_holes(const EmissionContext& context,
                                                     const Program& program,
                                                     const std::string& definition) {
  return {{"head", describe_source(program)},
          {"cost", describe_cost(program)},
          {"name", context.name},
          {"section", print_section_macro(context)},
          {"signature", print_section(context) + wrap_line(definition + " {", 0)}};
}

}  // namespace treeline
