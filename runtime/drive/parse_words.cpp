#include "drive/parse_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace treeline::drive {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// The number of letters to change, insert or remove.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t above = row[j + 1];
      row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] == b[j] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

}  // namespace

std::vector<Word> split_line(std::string_view line) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < line.size() && line[i] != '#';) {
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < line.size() && !is_blank(line[end]) && line[end] != '#') ++end;
    words.push_back({line.substr(i, end - i), i});
    i = end;
  }
  return words;
}

std::string suggest_word(std::string_view wanted, const std::vector<std::string>& names) {
  const std::string* nearest = nullptr;
  std::size_t least = wanted.size() < 4 ? 2 : std::min<std::size_t>(2 + wanted.size() / 8, 4) + 1;
  for (const std::string& name : names) {
    const std::size_t d = distance(wanted.substr(0, 64), name);
    if (d < least) {
      least = d;
      nearest = &name;
    }
  }
  if (nearest != nullptr) return fmt::format("did you mean `{}`?", *nearest);
  constexpr std::size_t kFew = 12;
  if (names.empty()) return "this robot has none";
  const std::size_t shown = std::min(names.size(), kFew);
  std::string text = fmt::format(
      "{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
  return "one of " + text;
}

std::string shown_word(std::string_view word) {
  std::string text;
  for (const char c : word.substr(0, 40)) {
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text + (word.size() > 40 ? "..." : "");
}

}  // namespace treeline::drive
