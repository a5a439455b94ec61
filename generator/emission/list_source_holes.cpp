#include "emission/list_source_holes.hpp"

#include "emission/comment.hpp"
#include "emission/describe_program.hpp"
#include "emission/print_target.hpp"
#include "emission/wrap_line.hpp"

namespace treeline {

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
