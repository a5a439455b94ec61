#include "emission/misra/follow_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "emission/c_family_syntax.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::misra {
namespace {

/// `Real(10)` as `10.0`, in float `10.0F`.
std::string write_literals(const EmissionContext& context, const std::string& code) {
  static const std::regex whole("\\b(?:Real|RealOf<Robot>)\\((-?[0-9]+)\\)");
  static const std::regex broken(
      "\\b(?:Real|RealOf<Robot>)\\((-?(?:[0-9]+[.e]|0x)[0-9a-fp.-]+)\\)");
  const std::string suffix = number_literal(context, "");
  return std::regex_replace(std::regex_replace(code, whole, "$1.0" + suffix), broken,
                            "$1" + suffix);
}

/// Lines that have become too long.
std::string wrap_lines(const std::string& code) {
  constexpr std::size_t kWidth = 100;
  std::istringstream lines(code);
  std::string wrapped;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    wrapped += line.size() > kWidth ? wrap_line(line.substr(blanks), blanks) : line + "\n";
  }
  return wrapped;
}

}  // namespace

std::string follow_rules(const EmissionContext& context, const std::string& code) {
  static const std::pair<std::regex, const char*> kRules[] = {
      {std::regex("#if defined\\(__GNUC__\\) && !defined\\(__clang__\\)\n(?:#pragma [^\n]*\n)+"
                  "#endif\n\n?"),
       ""},
      {std::regex("\\bint\\b"), "int32_t"},
      {std::regex("\\bsquare_root\\("), "root("}};
  static const std::regex left_over(
      "#pragma (?!once)|#define|__[a-z]|reinterpret_cast|\\bReal\\([^&]");
  std::string followed = write_literals(context, code);
  for (const auto& [pattern, by] : kRules) followed = std::regex_replace(followed, pattern, by);
  std::smatch found;
  if (std::regex_search(followed, found, left_over)) {
    throw std::logic_error(fmt::format("`{}` is not of `profile: misra`", found[0].str()));
  }
  return wrap_lines(followed);
}

}  // namespace treeline::misra
