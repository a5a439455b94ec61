#pragma once

#include <cctype>
#include <map>
#include <string>
#include <string_view>

/// Reads emitted C++ as a compiler does, as far as the numbers of lanes are concerned.
namespace treeline::tests {

namespace detail {

inline bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Number of values in a list whose opening parenthesis stands before `at`; `at` is then behind the
/// closing one.
inline int count_listed(std::string_view text, std::size_t& at) {
  int count = 1;
  for (int depth = 1; depth > 0; ++at) {
    depth += text.at(at) == '(' ? 1 : text[at] == ')' ? -1 : 0;
    count += depth == 1 && text[at] == ',' ? 1 : 0;
  }
  return count;
}

/// Whether every operand of the expression that is in lanes has `width` of them.
inline bool has_width(std::string_view expression, int width,
                      const std::map<std::string, int, std::less<>>& widths) {
  constexpr std::string_view kMake = "detail::make_pack<Real>(";
  for (std::size_t at = 0; at < expression.size();) {
    if (expression.substr(at).starts_with(kMake)) {
      at += kMake.size();
      if (count_listed(expression, at) != width) return false;
    } else if (is_of_word(expression[at])) {
      const std::size_t begin = at;
      while (at < expression.size() && is_of_word(expression[at])) ++at;
      const auto own = widths.find(expression.substr(begin, at - begin));
      const bool is_one_lane = at < expression.size() && expression[at] == '[';
      if (own != widths.end() && !is_one_lane && own->second != width) return false;
    } else {
      ++at;
    }
  }
  return true;
}

}  // namespace detail

/// What the declarations of lanes in emitted C++ say.
struct DeclaredLanes {
  std::map<std::string, int, std::less<>> widths;  ///< by name
  std::string mixed;  ///< the first that reads lanes of another number; empty if none does
};

inline DeclaredLanes read_lanes(std::string_view source) {
  constexpr std::string_view kType = "const Lanes<";
  DeclaredLanes read;
  for (std::size_t at = source.find(kType); at != std::string_view::npos;
       at = source.find(kType, at)) {
    const std::size_t end = source.find(';', at);
    const std::string_view statement = source.substr(at, end - at);
    const std::size_t name = statement.find("> ") + 2, equals = statement.find(" =", name);
    const int width = statement.at(kType.size()) - '0';
    if (read.mixed.empty() && !detail::has_width(statement.substr(equals), width, read.widths)) {
      read.mixed = statement;
    }
    read.widths.emplace(statement.substr(name, equals - name), width);
    at = end;
  }
  return read;
}

}  // namespace treeline::tests
