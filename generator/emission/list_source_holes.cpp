#include "emission/list_source_holes.hpp"

#include "emission/comment.hpp"
#include "emission/describe_program.hpp"
#include "emission/print_prefetch.hpp"
#include "emission/print_target.hpp"
#include "emission/wrap_line.hpp"

namespace treeline {

std::map<std::string, std::string> list_source_holes(const EmissionContext& context,
                                                     const Program& program,
                                                     const std::string& stem,
                                                     const std::string& definition) {
  // Loops that functions share are in no section of theirs.
  const Attributes attributes = program.loops ? Attributes::whole : Attributes::own;
  return {
      {"head", describe_source(program)},
      {"cost", describe_cost(program)},
      {"name", context.name},
      {"section", print_section_macro(context) + print_prefetch_macro(context, stem, attributes)},
      {"signature",
       print_section(context) + print_prefetch_section(context) + wrap_line(definition + " {", 0)}};
}

}  // namespace treeline
