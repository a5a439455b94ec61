#include "text/align_columns.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>

namespace treeline {
namespace {

constexpr std::size_t kGap = 2;
constexpr std::size_t kNarrowest = 8;     ///< least width of a column
constexpr std::size_t kComfortable = 30;  ///< which is enough for one in a table that is divided

using Rows = std::vector<std::vector<std::string>>;

std::string padded(const std::string& cell, const Column& column, std::size_t width) {
  const std::string space(width - std::min(width, width_of(cell)), ' ');
  return column.right ? space + cell : cell + space;
}

/// Finds the width of each column; 0 if all its cells are empty.
std::vector<std::size_t> find_widths(const std::vector<Column>& columns, const Rows& rows) {
  std::vector<std::size_t> widths(columns.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      widths[c] = std::max(widths[c], width_of(row[c]));
    }
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (widths[c] > 0) widths[c] = std::max(widths[c], width_of(columns[c].head));
  }
  return widths;
}

std::size_t total_of(const std::vector<std::size_t>& widths) {
  std::size_t total = 0;
  for (const std::size_t width : widths) total += width > 0 ? width + kGap : 0;
  return total;
}

bool may_break(const Column& column) {
  return !column.right && !column.whole;
}

/// Narrows the columns with the widest cells until the lines fit or no column can be narrowed
/// further.
void narrow(const std::vector<Column>& columns, std::size_t most,
            std::vector<std::size_t>& widths) {
  while (total_of(widths) > most) {
    std::size_t widest = columns.size();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!may_break(columns[c]) || widths[c] <= kNarrowest) continue;
      if (widest == columns.size() || widths[c] > widths[widest]) widest = c;
    }
    if (widest == columns.size()) return;
    --widths[widest];
  }
}

/// Divides columns that cannot stand side by side into groups, each with the first column.
std::vector<std::vector<std::size_t>> divide(const std::vector<Column>& columns,
                                             const std::vector<std::size_t>& widths,
                                             std::size_t most) {
  const auto needed = [&](std::size_t c) {
    return kGap + (may_break(columns[c]) ? std::min(widths[c], kComfortable) : widths[c]);
  };
  std::vector<std::vector<std::size_t>> groups;
  std::size_t used = most;
  for (std::size_t c = 1; c < widths.size(); ++c) {
    if (widths[c] == 0) continue;
    if (used + needed(c) > most) {
      groups.push_back({0});
      used = needed(0);
    }
    groups.back().push_back(c);
    used += needed(c);
  }
  return groups;
}

template <class Item>
std::vector<Item> choose(const std::vector<Item>& row, const std::vector<std::size_t>& group) {
  std::vector<Item> chosen;
  for (const std::size_t c : group) chosen.push_back(row[c]);
  return chosen;
}

/// Prints one row, in as many lines as its tallest cell needs.
std::string print_row(const std::vector<Column>& columns, const std::vector<std::size_t>& widths,
                      const std::vector<std::string>& row) {
  std::vector<std::vector<std::string>> cells;
  std::size_t lines = 1;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    cells.push_back(wrap_cell(row[c], std::max<std::size_t>(1, widths[c])));
    if (widths[c] > 0) lines = std::max(lines, cells[c].size());
  }
  std::string text;
  for (std::size_t i = 0; i < lines; ++i) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (widths[c] == 0) continue;
      line += std::string(kGap, ' ') +
              padded(i < cells[c].size() ? cells[c][i] : std::string(), columns[c], widths[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string print_groups(const std::vector<Column>& columns, const Rows& rows,
                         const std::vector<std::vector<std::size_t>>& groups, std::size_t most) {
  std::string text;
  for (const auto& group : groups) {
    Rows chosen;
    for (const auto& row : rows) chosen.push_back(choose(row, group));
    text += (text.empty() ? "" : "\n") + align_columns(choose(columns, group), chosen, most);
  }
  return text;
}

}  // namespace

std::string align_columns(const std::vector<Column>& columns, const Rows& rows, std::size_t most) {
  std::vector<std::size_t> widths = find_widths(columns, rows);
  if (most > 0) {
    const auto groups = divide(columns, widths, most);
    narrow(columns, most, widths);
    if (total_of(widths) > most && groups.size() > 1) {
      return print_groups(columns, rows, groups, most);
    }
  }
  std::vector<std::string> heads;
  for (const Column& column : columns) heads.push_back(column.head);
  std::string text = print_row(columns, widths, heads);
  for (const auto& row : rows) text += print_row(columns, widths, row);
  return text;
}

namespace {

constexpr std::size_t kPageColumns = 100;
constexpr std::size_t kFewest = 60;  ///< narrower tables would be all folds

std::size_t& measured() {
  static std::size_t columns = 0;
  return columns;
}

}  // namespace

std::size_t terminal_columns() {
  return measured();
}

std::size_t page_columns() {
  return measured() == 0 ? kPageColumns : std::min(kPageColumns, measured());
}

void fit_to_terminal() {
  winsize size{};
  const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  measured() = is_known ? std::max<std::size_t>(size.ws_col, kFewest) : 0;
}

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
