#include "emission/comment.hpp"

#include <algorithm>
#include <string_view>

#include "text/printable.hpp"

namespace treeline {

std::string comment(const std::string& mark, const std::string& text) {
  std::string commented;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    commented += mark + (end == begin ? "" : " ") + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return commented;
}

namespace {

/// Breaks up `??/` and its like, which C99 and C++14 read as one character: in a string, too, the
/// meaning stays the same.
void break_trigraphs(std::string& text) {
  constexpr std::string_view kThird = "=/'()!<>-";
  for (std::size_t at = text.find("??"); at != std::string::npos; at = text.find("??", at + 1)) {
    if (at + 2 < text.size() && kThird.find(text[at + 2]) != kThird.npos) {
      text.replace(at + 1, 1, "\\x3f");
    }
  }
}

}  // namespace

std::string harmless(const std::string& source) {
  std::string text = printable_lines(source);
  break_trigraphs(text);
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end)) {
    const std::size_t last = text.find_last_not_of(" \t", end == 0 ? 0 : end - 1);
    if (end > 0 && last != std::string::npos && text[last] == '\\') {
      text.insert(last + 1, "x5c");
      end += 3;
    }
    ++end;
  }
  return text;
}

std::string wrap_text(const std::string& text, std::size_t columns) {
  std::string wrapped;
  std::size_t begin = 0, room = columns;
  while (text.size() - begin > room) {
    const std::size_t blank = text.rfind(' ', begin + room);
    if (blank == std::string::npos || blank <= begin) break;
    wrapped += text.substr(begin, blank - begin) + "\n  ";
    begin = blank + 1;
    room = columns - 2;  // for the indent
  }
  return wrapped + text.substr(begin);
}

std::string in_comment(std::string text, std::size_t columns) {
  for (const char* mark : {"*/", "/*"}) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
      text.insert(at + 1, 1, ' ');
    }
  }
  std::string wrapped = wrap_text(text, columns);
  for (std::size_t at = wrapped.find('\n'); at != std::string::npos; at = wrapped.find('\n', at)) {
    wrapped.insert(at + 1, 1, ' ');
    at += 2;
  }
  return wrapped;
}

std::string describe_method(const Program& program) {
  const std::string words = describe(program.route);
  return words.empty() ? "" : wrap_text("By " + words + ".", 95) + "\n";
}

std::string describe_source(const Program& program) {
  const std::string& equation = program.equation;
  const std::string head = program.name + (equation.empty() ? "" : ": " + equation);
  return comment("//", wrap_text(head, 95) + "\n" + describe_method(program));
}

std::string describe_rounding(const EmissionContext& context, const std::string& source) {
  const auto rounding = context.rounding.find(source);
  if (rounding == context.rounding.end()) return {};
  return wrap_text("Rounding: " + rounding->second + ".", 95) + "\n";
}

}  // namespace treeline
