#include "emission/print_constants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "emission/backend.hpp"
#include "emission/wrap_line.hpp"

namespace treeline {

std::string print_constants(const Adaptation& own, std::span<const Constant> constants) {
  const ConstantSyntax& syntax = backend_of(own.language).constants;
  std::string text(syntax.opening);
  for (const Constant& each : constants) {
    text += fmt::format(fmt::runtime(syntax.line), constant_name(own, each.name), each.value);
    text += &each == &constants.back() ? syntax.last : syntax.between;
    text += *each.comment != '\0' ? fmt::format("  // {}\n", each.comment) : "\n";
  }
  return text.append(syntax.closing);
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
