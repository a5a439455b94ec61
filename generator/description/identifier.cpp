#include "description/identifier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace treeline {
namespace {

// Sorted: looked up by bisection.
constexpr std::array kTaken =
    std::to_array<std::string_view>({"Real",         "abs",          "acos",
                                     "alignas",      "alignof",      "and",
                                     "and_eq",       "asin",         "asm",
                                     "atan",         "auto",         "bitand",
                                     "bitor",        "bool",         "break",
                                     "case",         "catch",        "cbrt",
                                     "ceil",         "char",         "char16_t",
                                     "char32_t",     "char8_t",      "class",
                                     "co_await",     "co_return",    "co_yield",
                                     "compl",        "concept",      "const",
                                     "const_cast",   "consteval",    "constexpr",
                                     "constinit",    "continue",     "cos",
                                     "decltype",     "default",      "delete",
                                     "div",          "do",           "double",
                                     "dynamic_cast", "else",         "enum",
                                     "exit",         "exp",          "explicit",
                                     "export",       "extern",       "false",
                                     "float",        "floor",        "for",
                                     "friend",       "gamma",        "goto",
                                     "if",           "index",        "inline",
                                     "int",          "j0",           "j1",
                                     "jn",           "link",         "linux",
                                     "log",          "long",         "main",
                                     "mutable",      "namespace",    "new",
                                     "noexcept",     "not",          "not_eq",
                                     "nullptr",      "operator",     "or",
                                     "or_eq",        "posix",        "pow",
                                     "private",      "protected",    "public",
                                     "read",         "register",     "reinterpret_cast",
                                     "remove",       "requires",     "return",
                                     "round",        "short",        "signal",
                                     "signed",       "sin",          "sizeof",
                                     "sqrt",         "static",       "static_assert",
                                     "static_cast",  "std",          "struct",
                                     "switch",       "tan",          "template",
                                     "this",         "thread_local", "throw",
                                     "time",         "true",         "try",
                                     "typedef",      "typeid",       "typename",
                                     "union",        "unix",         "unsigned",
                                     "using",        "virtual",      "void",
                                     "volatile",     "wchar_t",      "while",
                                     "write",        "xor",          "xor_eq",
                                     "y0",           "y1",           "yn"});
static_assert(std::is_sorted(kTaken.begin(), kTaken.end()));

bool is_taken(std::string_view name) {
  return std::binary_search(kTaken.begin(), kTaken.end(), name);
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t length = 0;  ///< bytes taken; 0 when the text is not UTF-8 here
};

CodePoint decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  std::uint32_t value = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    value = value << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < kSmallest[length] || value > 0x10FFFF || surrogate) return {};
  return {value, length};
}

void append_underscore(std::string& identifier) {
  if (!identifier.empty() && identifier.back() != '_') identifier += '_';
}

}  // namespace

bool is_identifier(std::string_view name) {
  if (name.empty() || !is_letter(name.front())) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i]) && !is_digit(name[i]) && name[i] != '_') return false;
    if (name[i] == '_' && i + 1 < name.size() && name[i + 1] == '_') return false;
  }
  return !is_taken(name);
}

std::string identifier_from(std::string_view name) {
  std::string identifier;
  while (!name.empty()) {
    const CodePoint point = decode(name);
    const char first = name.front();
    if (point.length > 1) {
      identifier += fmt::format("u{:x}", point.value);
    } else if (is_letter(first) || is_digit(first)) {
      if (identifier.empty() && is_digit(first)) identifier += 'n';
      identifier += first;
    } else {
      append_underscore(identifier);
    }
    name.remove_prefix(std::max<std::size_t>(point.length, 1));
  }
  const bool trailing = !identifier.empty() && identifier.back() == '_';
  if (identifier.empty()) return "unnamed";
  if (is_taken(identifier) && !trailing) identifier += '_';
  return identifier;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const CodePoint point = decode(text);
    if (point.length == 0) return false;
    text.remove_prefix(point.length);
  }
  return true;
}

}  // namespace treeline
