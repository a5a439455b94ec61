#include <fmt/format.h>

#include "emission/c/print_files.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"

namespace treeline::c {
namespace {

std::string print_array_macro(const EmissionContext& context) {
  if (context.misra) return {};
  return fmt::format(
      "/// An array argument of so many elements: other languages than C99 see a pointer.\n"
      "#if defined(__cplusplus) || defined(_MSC_VER)\n"
      "#define TREELINE_{0}_ARRAY(size) (size)\n"
      "#else\n"
      "#define TREELINE_{0}_ARRAY(size) restrict static (size)\n"
      "#endif\n\n",
      name_in_capitals(context));
}

/// A type whose size is negative where constants of double are rounded to float.
std::string print_check_of_constants(const EmissionContext& context) {
  if (context.single_precision) return {};
  return fmt::format(
      "\n// Stops -fsingle-precision-constant, which would round every constant to float.\n"
      "typedef char {}_has_constants_of_double[(sizeof(1.0) == sizeof(double)) ? 1 : -1];",
      context.name);
}

/// Describes what the functions need: other files and standard headers.
std::string describe_needs(const EmissionContext& context, std::span<const Program> programs) {
  const bool loops = has_loops(programs);
  const bool flags = context.limits || !context.effective_mass_limits.empty();
  const char* const headers = loops   ? "<float.h>, <stdbool.h>, <stddef.h> and <stdint.h>"
                              : flags ? "<float.h>, <stdbool.h> and <stdint.h>"
                                      : "<float.h> and <stdint.h>";
  return fmt::format(
      "The code needs C99 and nothing else: no library, no heap, no {} {}. C++ may include this "
      "file too.\n"
      "Same input, same bits; and same time, where the target has instructions for {}.{}",
      loops ? "branch on data, no global state;\nof its headers"
            : "branch, no global state; of its\nheaders",
      headers, number_type(context),
      context.limits ? "\nLimited control branches, in a bounded number of steps." : "");
}

}  // namespace

std::string print_declarations(const EmissionContext& context, std::span<const Program> programs) {
  std::string declarations;
  for (const Program& program : programs) {
    declarations += declarations.empty() ? "" : "\n";
    declarations += fill_template(templates::kDeclaration,
                                  {{"comment", comment("///", describe_function(context, program))},
                                   {"signature", print_declaration(context, program)}});
  }
  return declarations;
}

std::string print_contract(const EmissionContext& context, std::span<const Program> programs) {
  const bool single = context.single_precision;
  auto values = describe_contract(context);
  values.insert({{"NAME", name_in_capitals(context)},
                 {"form", has_loops(programs) ? "straight-line code and loops of constant length"
                                              : "straight-line code"},
                 {"needs", comment("//", describe_needs(context, programs))},
                 {"array", print_array_macro(context)},
                 {"constants", print_check_of_constants(context)},
                 {"macros", single ? "FLT" : "DBL"},
                 {"exponent", single ? "128" : "1024"},
                 {"declarations", print_declarations(context, programs)}});
  return fill_template(templates::kContract, values);
}

}  // namespace treeline::c
