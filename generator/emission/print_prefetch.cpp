#include "emission/print_prefetch.hpp"

#include <fmt/format.h>

#include <map>

#include "emission/fill_template.hpp"
#include "emission/templates.hpp"
#include "emission/wrap_line.hpp"

namespace treeline {
namespace {

/// A name of C, so that the linker defines where the section begins and ends.
std::string section_of(const EmissionContext& context, const std::string& function) {
  return fmt::format("treeline_{}_{}", context.name, function);
}

std::string print_bounds(const EmissionContext& context, std::span<const Program> programs) {
  std::string text;
  for (const Program& program : programs) {
    const std::string section = section_of(context, program.name);
    text += fmt::format(
        "extern const char __start_{0}[] TREELINE_BOUND;\nextern const char __stop_{0}[] "
        "TREELINE_BOUND;\n",
        section);
  }
  return text;
}

}  // namespace

std::vector<GeneratedFile> print_prefetch(const EmissionContext& context,
                                          std::span<const Program> programs) {
  if (!context.prefetch) return {};
  const bool is_c = context.language == Language::c;
  const std::string prefix = is_c ? context.name + "_" : "";
  const char* const arguments = is_c ? "(void)" : "() noexcept";
  std::string declarations, definitions, nothing;
  for (const Program& program : programs) {
    const std::string head = fmt::format("void {}prefetch_{}{}", prefix, program.name, arguments);
    const std::string section = section_of(context, program.name);
    declarations += head + ";\n";
    definitions += head + " {\n" +
                   wrap_line(fmt::format("{0}load(__start_{1}, __stop_{1});", prefix, section), 2) +
                   "}\n";
    nothing += head + " {}\n";
  }
  const std::string header = is_c ? ".h" : ".hpp";
  return {{context.name + "_prefetch" + header,
           fill_template(
               is_c ? templates::kPrefetchHeaderC : templates::kPrefetchHeaderCpp,
               {{"robot", context.robot}, {"name", context.name}, {"declarations", declarations}})},
          {is_c ? "prefetch.c" : "prefetch.cpp",
           fill_template(is_c ? templates::kPrefetchC : templates::kPrefetchCpp,
                         {{"name", context.name},
                          {"bounds", print_bounds(context, programs)},
                          {"definitions", definitions},
                          {"nothing", nothing}})}};
}

std::string print_prefetch_macro(const EmissionContext& context, const Program& program) {
  if (!context.prefetch) return {};
  return fmt::format(
      "\n// For {}_prefetch: a section of its own.\n"
      "#undef TREELINE_OWN_SECTION  // of a file before, where a build joins sources\n"
      "#if defined(__ELF__) && defined(__GNUC__)\n"
      "#define TREELINE_OWN_SECTION __attribute__((section(\"{}\")))\n"
      "#else\n"
      "#define TREELINE_OWN_SECTION\n"
      "#endif\n",
      context.name, section_of(context, program.name));
}

std::string print_prefetch_section(const EmissionContext& context) {
  return context.prefetch ? "TREELINE_OWN_SECTION\n" : "";
}

}  // namespace treeline
