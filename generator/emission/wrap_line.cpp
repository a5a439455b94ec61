#include "emission/emitted_text.hpp"

namespace treeline {
namespace {

constexpr std::size_t kLineWidth = 100;

/// The blank to break at so that at most `width` characters stay on the line: in its second half,
/// the last of those in the fewest parentheses; else the last of all; else the first beyond, where
/// a long word leaves none; else npos.
std::size_t find_break(std::string_view text, std::size_t width) {
  std::size_t best = std::string_view::npos;
  int best_depth = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size() && (i <= width || best == text.npos); ++i) {
    depth += text[i] == '(' ? 1 : (text[i] == ')' ? -1 : 0);
    const bool behind_operator =
        i > 0 && text[i] == ' ' && std::string_view("+-*/=,").find(text[i - 1]) != text.npos;
    if (behind_operator && (best == text.npos || best < width / 2 || depth <= best_depth)) {
      best = i;
      best_depth = depth;
    }
  }
  return best;
}

}  // namespace

std::string wrap_line(std::string_view text, std::size_t indentation) {
  std::string lines;
  std::size_t blanks = indentation;
  while (blanks + text.size() > kLineWidth) {
    const std::size_t at = find_break(text, kLineWidth - blanks);
    if (at == std::string_view::npos) {
      break;
    }
    lines += std::string(blanks, ' ').append(text.substr(0, at)).append("\n");
    text.remove_prefix(at + 1);
    blanks = indentation + 4;
  }
  return lines + std::string(blanks, ' ').append(text).append("\n");
}

std::string wrap_in_hole(std::string_view text, std::size_t indentation) {
  const std::string wrapped = wrap_line(text, indentation);
  std::string lines;
  for (std::size_t at = 0; at < wrapped.size();) {
    const std::size_t end = wrapped.find('\n', at);
    if (!lines.empty()) lines += '\n';
    lines.append(wrapped, at + indentation, end - at - indentation);
    at = end + 1;
  }
  return lines;
}

}  // namespace treeline
