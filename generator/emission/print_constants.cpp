#include "emission/print_constants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "emission/backend.hpp"
#include "emission/wrap_line.hpp"

namespace treeline {

std::string print_constants(const Adaptation& own, std::span<const Constant> constants) {
  const bool is_c = !backend_of(own.language).has_namespaces;
  std::string text = is_c ? "enum {\n" : "";
  for (const Constant& each : constants) {
    const bool last = &each == &constants.back();
    const std::string name = constant_name(own, each.name);
    text += is_c ? fmt::format("  {} = {}{}", name, each.value, last ? "" : ",")
                 : fmt::format("inline constexpr int32_t {} = {};", name, each.value);
    text += *each.comment != '\0' ? fmt::format("  // {}\n", each.comment) : "\n";
  }
  return is_c ? text + "};\n" : text;
}

std::string print_table(const std::string& declared, std::vector<std::string> entries,
                        std::size_t indentation) {
  if (entries.empty()) entries.emplace_back("0");
  return wrap_line(
      fmt::format("{}[{}] = {{{}}};", declared, entries.size(), fmt::join(entries, ", ")),
      indentation);
}

std::string print_sizes(const std::string& robot, const Adaptation& own, std::string_view header,
                        std::span<const Constant> sizes) {
  Adaptation filled = own;
  filled.words["TL_CONTRACT"] = robot;
  filled.words["TL_CONSTANTS"] = print_constants(own, sizes);
  return adapt(header, filled);
}

}  // namespace treeline
