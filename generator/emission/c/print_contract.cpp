#include "emission/c/print_contract.hpp"

#include "emission/c/print_source.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/describe_contract.hpp"
#include "emission/fill_template.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::c {

std::string print_contract(const EmissionContext& context, std::span<const Program> programs) {
  std::string declarations;
  for (const Program& program : programs) {
    declarations += declarations.empty() ? "" : "\n";
    declarations +=
        fill_template(templates::kDeclaration,
                      {{"comment", comment("///", describe_function(context, program))},
                       {"signature", wrap_line(print_signature(context, program) + ";", 0)}});
  }
  const bool single = context.single_precision;
  auto values = describe_contract(context);
  values.insert({{"NAME", name_in_capitals(context)},
                 {"macros", single ? "FLT" : "DBL"},
                 {"exponent", single ? "128" : "1024"},
                 {"declarations", declarations}});
  return fill_template(templates::kContract, values);
}

}  // namespace treeline::c
