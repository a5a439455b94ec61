#include "text/align_columns.hpp"

#include <algorithm>

#include "text/wrap_words.hpp"

namespace treeline {
namespace {

constexpr std::size_t kGap = 2;
constexpr std::size_t kNarrowest = 8;  ///< least width of a column

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

/// Narrows the columns with the widest cells until the lines fit or no column can be narrowed
/// further.
void narrow(const std::vector<Column>& columns, std::size_t most,
            std::vector<std::size_t>& widths) {
  while (total_of(widths) > most) {
    std::size_t widest = columns.size();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].right || widths[c] <= kNarrowest) continue;
      if (widest == columns.size() || widths[c] > widths[widest]) widest = c;
    }
    if (widest == columns.size()) return;
    --widths[widest];
  }
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

}  // namespace

std::string align_columns(const std::vector<Column>& columns, const Rows& rows, std::size_t most) {
  std::vector<std::size_t> widths = find_widths(columns, rows);
  if (most > 0) narrow(columns, most, widths);
  std::vector<std::string> heads;
  for (const Column& column : columns) heads.push_back(column.head);
  std::string text = print_row(columns, widths, heads);
  for (const auto& row : rows) text += print_row(columns, widths, row);
  return text;
}

}  // namespace treeline
