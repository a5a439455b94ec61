#include "emission/c/lift_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "emission/comment.hpp"

namespace treeline::c {
namespace {

/// A function of the header: what its comment says, and the lines between its braces.
struct Step {
  std::string meaning;
  std::string body;
};

/// The steps in their order, and whether each has a function of its own for `float`.
constexpr std::array<std::pair<const char*, bool>, 5> kSteps = {{{"within_range", false},
                                                                 {"nearest_quarter", false},
                                                                 {"subtract_quarters", true},
                                                                 {"sin_cos_remainder", true},
                                                                 {"rotate_by_quarters", false}}};

[[noreturn]] void reject(std::string_view what, std::string_view why) {
  throw std::logic_error(fmt::format("sin_cos.hpp: {} {}", what, why));
}

/// The comment that ends where `at` is, in one line.
std::string comment_before(std::string_view header, std::size_t at) {
  std::vector<std::string> lines;
  while (at > 0) {
    const std::size_t begin = header.rfind('\n', at - 2) + 1;
    const std::string_view line = header.substr(begin, at - 1 - begin);
    if (!line.starts_with("/// ")) break;
    lines.emplace_back(line.substr(4));
    at = begin;
  }
  std::reverse(lines.begin(), lines.end());
  return fmt::format("{}", fmt::join(lines, " "));
}

Step find_step(std::string_view header, const std::string& function) {
  constexpr std::string_view kTemplate = "template <class Lanes>\n";
  constexpr std::string_view kOpen = "noexcept {\n";
  const std::size_t name = header.find(" void " + function + "(");
  const std::size_t open = header.find(kOpen, name);
  const std::size_t close = header.find("\n}\n", open);
  const std::size_t begin = header.rfind(kTemplate, name);
  if (name == header.npos || close == header.npos || begin == header.npos) {
    reject(function, "is missing");
  }
  const std::size_t first = open + kOpen.size();
  return {comment_before(header, begin), std::string(header.substr(first, close + 1 - first))};
}

/// The place of the parenthesis that closes the one at `open`.
std::size_t find_close(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i;
  }
  reject(text, "lacks a parenthesis");
}

/// A formula with its products in parentheses where they are part of a sum, as in all emitted C.
std::string parenthesize(std::string_view text) {
  std::vector<std::string> terms(1), signs;
  std::vector<bool> is_product(1, false);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view three = text.substr(i, 3);
    if (three == " + " || three == " - ") {
      signs.emplace_back(three);
      terms.emplace_back();
      is_product.push_back(false);
      i += 2;
    } else if (text[i] == '(') {
      const std::size_t close = find_close(text, i);
      terms.back() += fmt::format("({})", parenthesize(text.substr(i + 1, close - i - 1)));
      i = close;
    } else {
      is_product.back() = is_product.back() || text[i] == '*';
      terms.back() += text[i];
    }
  }
  std::string joined;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    joined += i > 0 ? signs[i - 1] : "";
    joined += terms.size() > 1 && is_product[i] ? fmt::format("({})", terms[i]) : terms[i];
  }
  return joined;
}

/// The same for every line that assigns a formula of numbers.
std::string parenthesize_lines(const std::string& text) {
  const std::regex formula("^([^=]* = )([^=&|^<>~]* \\* [^=&|^<>~]*);$");
  std::istringstream lines(text);
  std::string changed;
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    const bool is_formula = std::regex_match(line, found, formula);
    changed += is_formula ? found[1].str() + parenthesize(found[2].str()) + ";" : line;
    changed += "\n";
  }
  return changed;
}

/// Statements of C++ as the steps are written in, in C.
std::string translate(const std::string& text, const std::string& name, bool single_precision) {
  const std::string bits = single_precision ? "uint32_t" : "uint64_t";
  const std::string real = single_precision ? "float" : "double";
  const std::vector<std::pair<std::regex, std::string>> rules = {
      {std::regex("^  using [^;]*;\n", std::regex::multiline), ""},
      {std::regex("static constexpr "), "const "},
      {std::regex("constexpr "), "const "},
      {std::regex("const int (\\w+ = \\w+);"), fmt::format("const {} $1U;", bits)},
      {std::regex("kSignAt - 1\\)"), "kSignAt - 1U)"},
      {std::regex("typename Lanes::Value|\\bValue\\b"), real},
      {std::regex("\\bBits?\\{(\\w+)\\}"), fmt::format("({})$1", bits)},
      {std::regex("\\bBits?\\{(\\w+) \\+ (\\w+)\\}"), fmt::format("(({0})$1 + ({0})$2)", bits)},
      {std::regex("typename Lanes::Bits|\\bBits?\\b(?= )"), bits},
      {std::regex("Lanes::(to|from)_bits\\((\\w+), (\\w+)\\)"),
       fmt::format("{}_$1_bits(&$2, &$3)", name)},
      {std::regex("\\bF::"), ""},
      {std::regex("^  ", std::regex::multiline), ""}};
  std::string translated = text;
  for (const auto& [pattern, by] : rules) {
    translated = std::regex_replace(translated, pattern, by);
  }
  static const std::regex left_over("::|\\{|<[a-zA-Z]|typename|using|constexpr|static_cast|auto ");
  if (std::regex_search(translated, left_over)) reject(translated, "is not to be had in C");
  return parenthesize_lines(translated);
}

/// The constants of the number's format that `steps` use.
std::string find_constants(std::string_view header, const std::string& steps,
                           const std::string& name, bool single_precision) {
  const std::string open =
      fmt::format("struct Format<{}> {{\n", single_precision ? "float" : "double");
  const std::size_t begin = header.find(open);
  const std::size_t end = header.find("};\n", begin);
  if (begin == header.npos || end == header.npos) reject(open, "is missing");
  std::istringstream lines{
      std::string(header.substr(begin + open.size(), end - begin - open.size()))};
  const std::regex constant("static constexpr \\w+ (\\w+) =");
  std::string constants;
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_search(line, found, constant)) continue;
    const std::regex used("\\b" + found[1].str() + "\\b");
    if (std::regex_search(steps, used)) constants += translate(line + "\n", name, single_precision);
  }
  return constants;
}

}  // namespace

std::map<std::string, std::string> lift_steps(std::string_view header, const std::string& name,
                                              bool single_precision) {
  const std::string suffix = single_precision ? "_float" : "";
  std::map<std::string, std::string> lifted;
  std::string all;
  for (const auto& [function, has_own_for_float] : kSteps) {
    const Step step = find_step(header, function + (has_own_for_float ? suffix : std::string()));
    const std::string body = translate(step.body, name, single_precision);
    lifted[function] = comment("//", wrap_text(step.meaning, 92)) + body;
    all += body;
  }
  lifted["constants"] = find_constants(header, all, name, single_precision);
  return lifted;
}

}  // namespace treeline::c
