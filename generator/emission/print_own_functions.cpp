#include <fmt/format.h>

#include "emission/backend.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"

namespace treeline {

std::string print_own_functions(const EmissionContext& context,
                                const std::vector<const Program*>& programs,
                                const std::string& stem, const std::string& what) {
  const Backend& backend = backend_of(context.language);
  std::string declarations;
  for (const Program* const program : programs) {
    declarations += backend.print_declaration(context, *program) + "\n";
  }
  const std::string front = fmt::format(
      "#pragma once\n// What {2} calls beside the functions of {0}{1}.\n"
      "// Generated; see {0}_{3}.h for the contract.\n#include \"{0}{1}\"\n\n",
      context.name, backend.header, what, stem);
  if (!backend.has_namespaces) return front + declarations;
  return fmt::format("{1}namespace {0} {{\n\n{2}\n}}  // namespace {0}\n", context.name, front,
                     declarations);
}

std::string print_own_source(const EmissionContext& context, const Program& program,
                             const std::string& stem) {
  const Backend& backend = backend_of(context.language);
  const std::string contract = fmt::format("#include \"{}{}\"", context.name, backend.header);
  std::string text = backend.print_source(context, program);
  return text.replace(text.find(contract), contract.size(),
                      fmt::format("#include \"{}_functions{}\"", stem, backend.header));
}

std::string print_own_call(const EmissionContext& context, const Program& program,
                           const std::string& arguments) {
  const std::string prefix = backend_of(context.language).has_namespaces ? "" : context.name + "_";
  return wrap_in_hole(fmt::format("{}{}({});", prefix, program.name, arguments), 2);
}

}  // namespace treeline
