#include <fmt/format.h>

#include "emission/comment.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"

namespace treeline::cpp {
namespace {

constexpr const char* kBeside =
    "//   {0}_calls.hpp: the functions with named inputs, std::array and pointers\n"
    "//   {0}_eigen.hpp: the functions for Eigen\n";

constexpr const char* kConstants =
    "\nstatic_assert(sizeof(1.0) == sizeof(Real), \"compile without "
    "-fsingle-precision-constant\");";

}  // namespace

std::string print_contract(const EmissionContext& context, std::span<const Program> programs) {
  std::string declarations;
  for (const Program& program : programs) {
    declarations += declarations.empty() ? "" : "\n";
    declarations += fill_template(templates::kDeclaration,
                                  {{"comment", comment("///", describe_function(context, program))},
                                   {"signature", print_declaration(program)}});
  }
  const bool single = context.single_precision;
  const bool loops = has_loops(programs);
  auto values = describe_contract(context);
  values.insert(
      {{"beside", context.misra ? "" : fmt::format(kBeside, context.name)},
       {"includes", context.misra ? "\n#include <stdint.h>" : ""},
       {"form", loops ? "straight-line code and loops of constant length" : "straight-line code"},
       {"branch", loops ? "no branch on data" : "no branch"},
       {"and_same", loops ? "and" : "and same"},
       {"time_where", loops ? "same time, where" : "time, where"},
       {"integer", context.misra ? "int32_t" : "int"},
       {"bytes", single ? "4" : "8"},
       {"fraction", single ? "23" : "52"},
       {"least", single ? "149" : "1074"},
       {"f", single ? "F" : ""},
       {"constants", single ? "" : kConstants},
       {"declarations", declarations}});
  return fill_template(templates::kContract, values);
}

}  // namespace treeline::cpp
