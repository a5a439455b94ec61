#include "emission/print_prefetch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "emission/controller_unit.hpp"
#include "emission/count_stack.hpp"
#include "emission/fill_template.hpp"
#include "emission/templates.hpp"
#include "emission/wrap_line.hpp"

namespace treeline {
namespace {

constexpr const char* kStep = "step";

/// A name of C, so that the linker defines where the section begins and ends.
std::string section_of(const EmissionContext& context, const std::string& function) {
  return fmt::format("treeline_{}_{}", context.name, function);
}

std::string print_bounds(const EmissionContext& context, const std::vector<LoadedCode>& codes) {
  std::string text;
  for (const LoadedCode& code : codes) {
    for (const std::string& function : code.functions) {
      text += fmt::format(
          "extern const char __start_{0}[] TREELINE_BOUND;\nextern const char __stop_{0}[] "
          "TREELINE_BOUND;\n",
          section_of(context, function));
    }
  }
  return text;
}

/// Writes a byte of each line of the stack below the caller, of which it reads nothing else.
std::string print_stack_writes(const EmissionContext& context, std::size_t bytes) {
  if (bytes == 0) return {};
  const bool is_c = context.language == Language::c;
  return fmt::format(
      "  volatile char stack[{0}];  // of the function that is called next, too\n"
      "  for (int i = 0; i < {0}; i += {1}) {{\n    stack[i] = 0;\n  }}\n  {2};\n",
      bytes, is_c ? context.name + "_line" : "kLine",
      is_c ? "(void)stack[0]" : "static_cast<void>(stack[0])");
}

/// `head` as it is declared; of a controller with what it loads.
std::string declare(const EmissionContext& context, const LoadedCode& code,
                    const std::string& head) {
  const bool is_step = code.name == kStep;
  return (is_step ? fmt::format("/// Loads {}_step and the dynamics that it calls.\n", context.name)
                  : "") +
         head + ";\n";
}

GeneratedFile print_header(const EmissionContext& context, const std::string& declarations,
                           bool is_c) {
  return {context.name + (is_c ? "_prefetch.h" : "_prefetch.hpp"),
          fill_template(
              is_c ? templates::kPrefetchHeaderC : templates::kPrefetchHeaderCpp,
              {{"robot", context.robot}, {"name", context.name}, {"declarations", declarations}})};
}

}  // namespace

std::vector<LoadedCode> list_loaded(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const auto count_bytes = [&](const Program& program) {
    return count_stack_values(program, false) * static_cast<std::size_t>(number_bytes(context));
  };
  std::vector<LoadedCode> codes;
  for (const Program& program : contents.programs) {
    codes.push_back({program.name, {program.name}, count_bytes(program)});
  }
  for (const Program& program : contents.batch) {
    codes.push_back({"batch_" + program.name, {"batch_" + program.name}});
  }
  if (!context.controller) return codes;
  LoadedCode& step = codes.emplace_back(LoadedCode{kStep, {kControllerStem}});
  for (const Program* program : context.controller->programs()) {
    step.functions.push_back(program->name);
    step.stack = std::max(step.stack, count_bytes(*program));
  }
  return codes;
}

GeneratedFile print_prefetch_for_c(const Contents& contents) {
  const EmissionContext& context = contents.context;
  std::string declarations;
  for (const LoadedCode& code : list_loaded(contents)) {
    declarations +=
        declare(context, code, fmt::format("void {}_prefetch_{}(void)", context.name, code.name));
  }
  return print_header(context, declarations, true);
}

std::vector<GeneratedFile> print_prefetch(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const std::vector<LoadedCode> codes = list_loaded(contents);
  const bool is_c = context.language == Language::c;
  const std::string prefix = is_c ? context.name + "_" : "";
  const char* const arguments = is_c ? "(void)" : "() noexcept";
  std::string declarations, definitions, nothing;
  for (const LoadedCode& code : codes) {
    const std::string head = fmt::format("void {}prefetch_{}{}", prefix, code.name, arguments);
    declarations += declare(context, code, head);
    definitions += head + " {\n";
    for (const std::string& function : code.functions) {
      const std::string section = section_of(context, function);
      definitions +=
          wrap_line(fmt::format("{0}load(__start_{1}, __stop_{1});", prefix, section), 2);
    }
    definitions += print_stack_writes(context, code.stack) + "}\n";
    nothing += head + " {}\n";
  }
  return {print_header(context, declarations, is_c),
          {is_c ? "prefetch.c" : "prefetch.cpp",
           fill_template(is_c ? templates::kPrefetchC : templates::kPrefetchCpp,
                         {{"name", context.name},
                          {"bounds", print_bounds(context, codes)},
                          {"definitions", definitions},
                          {"nothing", nothing}})}};
}

std::string print_prefetch_macro(const EmissionContext& context, const std::string& function,
                                 Attributes attributes) {
  if (!context.prefetch) return {};
  return fmt::format(
      "\n// For {}_prefetch: a section of its own.\n"
      "#undef TREELINE_OWN_SECTION  // of a file before, where a build joins sources\n"
      "#if defined(__ELF__) && defined(__GNUC__)\n"
      "#define TREELINE_OWN_SECTION __attribute__((section(\"{}\"){}))\n"
      "#else\n"
      "#define TREELINE_OWN_SECTION\n"
      "#endif\n",
      context.name, section_of(context, function),
      attributes == Attributes::whole ? ", flatten" : "");
}

std::string print_prefetch_section(const EmissionContext& context) {
  return context.prefetch ? "TREELINE_OWN_SECTION\n" : "";
}

}  // namespace treeline
