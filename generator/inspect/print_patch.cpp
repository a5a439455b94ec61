#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "inspect/inspect_robot.hpp"

namespace treeline {
namespace {

/// Splits the text into lines, which keep their line ends.
std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return lines;
}

std::string marked(char mark, std::string_view line) {
  const bool ended = line.ends_with('\n');
  return fmt::format("{}{}{}", mark, line, ended ? "" : "\n\\ No newline at end of file\n");
}

/// Whole lines that edits affect, and their replacement.
struct ChangedText {
  std::size_t first_line = 0, lines = 0;
  std::string text;
};

/// Groups the edits into changes. Edits on the same line are one change.
std::vector<ChangedText> find_changes(const std::string& text, const std::vector<TextEdit>& edits) {
  const auto lines_before = [&](std::size_t at) {
    return static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
  };
  std::vector<ChangedText> changes;
  for (std::size_t i = 0; i < edits.size();) {
    const std::size_t before =
        edits[i].at == 0 ? std::string::npos : text.rfind('\n', edits[i].at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    std::size_t end = begin;
    std::vector<TextEdit> inside;
    while (i < edits.size() && (inside.empty() || edits[i].at < end)) {
      inside.push_back(edits[i]);
      inside.back().at -= begin;
      end = std::min(text.find('\n', edits[i].at + edits[i].size), text.size() - 1) + 1;
      ++i;
    }
    const std::string old = text.substr(begin, end - begin);
    changes.push_back({lines_before(begin), split_lines(old).size(), apply_edits(old, inside)});
  }
  return changes;
}

std::string safe_name(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return name;
}

constexpr std::size_t kContext = 3;

/// Prints changes as hunks. Changes whose context overlaps share a hunk.
class HunkPrinter {
 public:
  explicit HunkPrinter(const std::string& text) : lines_(split_lines(text)) {}

  std::string print(const std::vector<ChangedText>& changes) {
    std::string patch;
    for (std::size_t i = 0; i < changes.size();) {
      std::size_t next = i + 1;
      while (next < changes.size() &&
             changes[next].first_line <= end_of(changes[next - 1]) + 2 * kContext) {
        ++next;
      }
      patch += print_hunk(
          {changes.begin() + static_cast<long>(i), changes.begin() + static_cast<long>(next)});
      i = next;
    }
    return patch;
  }

 private:
  static std::size_t end_of(const ChangedText& change) { return change.first_line + change.lines; }

  std::string print_hunk(const std::vector<ChangedText>& changes) {
    const std::size_t first =
        changes.front().first_line - std::min(changes.front().first_line, kContext);
    const std::size_t end = std::min(end_of(changes.back()) + kContext, lines_.size());
    std::string body;
    std::size_t line = first, added = 0, removed = 0;
    for (const ChangedText& change : changes) {
      for (; line < change.first_line; ++line) body += marked(' ', lines_[line]);
      for (; line < end_of(change); ++line) body += marked('-', lines_[line]);
      removed += change.lines;
      for (const std::string_view text : split_lines(change.text)) {
        body += marked('+', text);
        ++added;
      }
    }
    for (; line < end; ++line) body += marked(' ', lines_[line]);
    const std::size_t old_count = end - first, new_count = old_count - removed + added;
    const auto new_first = static_cast<long>(first) + shift_;
    shift_ += static_cast<long>(added) - static_cast<long>(removed);
    return fmt::format("@@ -{},{} +{},{} @@\n{}", first + 1, old_count, new_first + 1, new_count,
                       body);
  }

  std::vector<std::string_view> lines_;
  long shift_ = 0;
};

}  // namespace

std::string apply_edits(const std::string& text, const std::vector<TextEdit>& edits) {
  std::string result;
  std::size_t at = 0;
  for (const TextEdit& edit : edits) {
    result.append(text, at, edit.at - at);
    result += edit.text;
    at = edit.at + edit.size;
  }
  return result.append(text, at, text.size() - at);
}

std::string print_patch(const std::string& file, const std::string& text,
                        const std::vector<TextEdit>& edits) {
  if (edits.empty()) return {};
  const std::string name = safe_name(file);
  return fmt::format("--- {}\n+++ {}\n{}", name, name,
                     HunkPrinter(text).print(find_changes(text, edits)));
}

}  // namespace treeline
