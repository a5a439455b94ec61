#include "text/wrap_words.hpp"

#include <algorithm>
#include <string_view>

namespace treeline {
namespace {

bool begins_code_point(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// Number of bytes of the first `code_points` code points.
std::size_t bytes_of(std::string_view text, std::size_t code_points) {
  std::size_t at = 0;
  for (std::size_t seen = 0; at < text.size(); ++at) {
    if (begins_code_point(text[at]) && seen++ == code_points) break;
  }
  return at;
}

/// Finds where to break a text that is too long: after the last of these characters within its
/// first `most` bytes.
std::size_t find_break(std::string_view text, std::size_t most) {
  const auto blank = text.substr(0, most + 1).rfind(' ');
  if (blank != std::string_view::npos && blank > 0) return blank;
  const auto joint = text.substr(0, most).find_last_of("_-/.");
  if (joint != std::string_view::npos && joint >= most / 3) return joint + 1;
  return most;
}

}  // namespace

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_code_point));
}

std::vector<std::string> wrap_cell(const std::string& text, std::size_t columns) {
  if (width_of(text) <= columns) return {text};
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  const std::string indent(std::min(first, columns / 2), ' ');
  const std::size_t room = std::max<std::size_t>(1, columns - indent.size());
  std::string_view rest = std::string_view(text).substr(first);
  std::vector<std::string> lines;
  while (width_of(std::string(rest)) > room) {
    const std::size_t at = std::max<std::size_t>(1, find_break(rest, bytes_of(rest, room)));
    lines.push_back(indent + std::string(rest.substr(0, at)));
    rest.remove_prefix(at);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  }
  if (!rest.empty()) lines.push_back(indent + std::string(rest));
  return lines;
}

std::string wrap_labelled(const std::string& label, const std::string& text, std::size_t columns) {
  const std::size_t room = columns - std::min(columns - 1, width_of(label));
  std::string wrapped;
  for (const std::string& line : wrap_cell(text, room)) {
    wrapped += (wrapped.empty() ? label : std::string(width_of(label), ' ')) + line + "\n";
  }
  return wrapped;
}

}  // namespace treeline
